#!/usr/bin/env bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers
#
# Remeshes CGAL's meshes and those given in all modes, with and without tests of self-intersection. Counts the pairs of faces that
# intersect, and compares the times. See benchmark_self_intersections.cpp. The exit status is 0 if no result has more pairs than its
# input. It takes long: meshes of up to 6 MB, 16 runs of each twice, short ones again. With --pairs each is run once, with the tests,
# without times.
# Usage: scripts/benchmark_self_intersections.sh [--pairs] [MESH...]
# BUILD_DIR (default build/benchmark) and JOBS (default 2) may be set in the environment.

set -euo pipefail
options=()
if [[ ${1:-} == --pairs ]]; then
  options+=(--pairs)
  shift
fi
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
absolute_paths "$@"
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build_benchmark benchmark_self_intersections
mapfile -t of_cgal < <(find "$data" -type f \( -name '*.off' -o -name '*.ply' \) -size -6M | sort)
"$program" "${options[@]}" "${of_cgal[@]}" "${meshes[@]}"
