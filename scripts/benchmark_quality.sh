#!/usr/bin/env bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Remeshes the ellipsoid 1:2:5 and the torus 1, 1/4 with their exact functions for sigma from 0 to 1 D, fills a coarse ellipsoid
# in, and remeshes CGAL's bunny and the meshes given to their own number of faces for sigma from .005 to .05 D. Prints a line
# of figures each, for sigma 0 beside those of CGAL's isotropic_remeshing.
# Usage: scripts/benchmark_quality.sh [MESH...]
# BUILD_DIR (default build/benchmark) and JOBS (default 2) may be set in the environment.

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
absolute_paths "$@"
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build_benchmark benchmark_remeshing
meshes+=("$data/bunny00.off")
for faces in 4000 40000; do # 2,000 and 20,000 vertices
  for shape in ellipsoid torus; do
    "$program" $shape $faces 0 --iso --runs 1
    for sigma in .02 .05 .1 .2 .5 1; do
      "$program" $shape $faces $sigma
    done
  done
done
"$program" ellipsoid 9996 .15              # 5,000 vertices
"$program" coarse-ellipsoid 39996 .15      # from 2,562 to 20,000 vertices
for mesh in "${meshes[@]}"; do
  "$program" "$mesh" 100% 0 --iso --runs 1
  for sigma in .005 .01 .02 .05; do
    "$program" "$mesh" 100% $sigma
  done
done
