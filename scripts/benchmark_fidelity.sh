#!/usr/bin/env bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Whether the smooth surface stays on the facets that it is built from: distances from the facets of CGAL's meshes, and of those
# given, to the zero set and back; the zero set of reduced meshes against the whole ones; cylinders, tubes, cones and plates as CAD
# programs write them. Prints three tables, see benchmark_fidelity.cpp. About three minutes.
# With --all: all meshes are reduced, and there are more of those shapes. Half an hour.
# Usage: scripts/benchmark_fidelity.sh [--all] [MESH...]
# BUILD_DIR (default build/benchmark) and JOBS (default 2) may be set in the environment.

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
options=()
if [[ "${1:-}" == --all ]]; then
  options+=(--all)
  shift
fi
absolute_paths "$@"
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build_benchmark benchmark_fidelity
of_cgal=()
for name in armadillo bunny00 lion-head camel hand head dino cactus mannequin-devil nefertiti ChineseDragon-10kv refined_elephant \
  rotor fandisk_large anchor_dense; do
  of_cgal+=("$data/$name.off")
done
reduced=("$data/armadillo.off" "$data/bunny00.off" "$data/lion-head.off" "$data/camel.off" "$data/dino.off")
if ((${#options[@]} > 0)); then
  reduced=("${of_cgal[@]}")
fi
"$program" --facets "${of_cgal[@]}" "${meshes[@]}"
"$program" --truth "${reduced[@]}" "${meshes[@]}"
"$program" --cad "${options[@]}"
