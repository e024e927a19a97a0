#!/usr/bin/env bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Builds the benchmark for this machine and prints the figures of a remeshing a line: of CGAL's bunny, of the ellipsoid
# 1:2:5 with its exact function, and of the meshes given.
# Usage: scripts/benchmark_remeshing.sh [MESH[:FACES[:SIGMA]]...]
# FACES is a number or, with a percent sign, a share of the input's (default 100%); SIGMA is a fraction of the diagonal of the
# bounding box (default .01). The meshes given are remeshed by CGAL's isotropic_remeshing, too, to compare the times:
# let nothing else run. For the Stanford bunny, say: scripts/benchmark_remeshing.sh bunny.obj:110350 bunny.obj:39800:.02
# BUILD_DIR (default build/benchmark) and JOBS (default 2) may be set in the environment.

set -euo pipefail
# relative to where the user is, not to the repository
meshes=()
for argument in "$@"; do
  IFS=: read -r file faces sigma <<< "$argument"
  meshes+=("$(realpath "$file")" "${faces:-100%}" "${sigma:-.01}")
done
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh

build_benchmark benchmark_remeshing
"$program" "$data/bunny00.off" 75408 .01 --iso
"$program" ellipsoid 9996 .15 --iso # 5,000 vertices
for ((i = 0; i < ${#meshes[@]}; i += 3)); do
  "$program" "${meshes[i]}" "${meshes[i + 1]}" "${meshes[i + 2]}" --iso
done
