#!/usr/bin/env bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Remeshes CGAL's fandisk to 1,500 and 6,000 vertices, in several embeddings, with one smooth function and with one for each region
# between its creases; CGAL's fandisk_large, anchor_dense and cheese, creases from 20 degrees on, and the meshes given, from 30
# degrees on, to all, half and twice as many vertices as they have; and CGAL's bunny, which has no sharp edges, with 60 degrees.
# Prints a line of figures each: distances, normals, curves, corners, folds, intersections and time.
# Usage: scripts/benchmark_creases.sh [MESH...]
# BUILD_DIR (default build/benchmark) and JOBS (default 2) may be set in the environment.

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
absolute_paths "$@"
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# at_three_sizes MESH DEGREES
at_three_sizes() {
  local count
  for count in 100% 50% 200%; do
    "$program" "$1" "$2" $count .01 p2
  done
}

build_benchmark benchmark_creases
for vertices in 1500 6000; do
  "$program" "$data/fandisk.off" 20 $vertices smooth.01 .005 .01 .02 .03 p2 p2f
done
"$program" "$data/fandisk.off" 10 6000 .005 .01
for mesh in fandisk_large anchor_dense cheese; do
  at_three_sizes "$data/$mesh.off" 20
done
for mesh in "${meshes[@]}"; do
  at_three_sizes "$mesh" 30
done
"$program" "$data/bunny00.off" 60 100% smooth.01 .01
