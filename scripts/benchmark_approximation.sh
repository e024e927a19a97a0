#!/usr/bin/env bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Remeshes the ellipsoid 1:2:5 and the torus 1, 1/4 to 5,000 vertices in several embeddings, with vertices on the surface and fitted
# to it, and to given errors; and CGAL's meshes bunny00 and elephant, and the meshes given, to given errors. Prints the distance to
# the surface over the diagonal D and over the asymptotic bound, and beside errors how many faces CGAL's isotropic_remeshing needs.
# Usage: scripts/benchmark_approximation.sh [MESH...]
# BUILD_DIR (default build/benchmark) and JOBS (default 2) may be set in the environment.

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
absolute_paths "$@"
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build_benchmark benchmark_embeddings
echo "ellipsoid 1:2:5"
"$program" ellipsoid 9996 .15 .2 .3 auto p1 p2 pinf .15f p2f pinff e1e-3 e1e-4
echo "torus 1, 1/4"
"$program" torus 10000 .05 .15 .2 auto p1 p2 pinf .15f p2f pinff e1e-3 e1e-4
for mesh in "$data/bunny00.off" "$data/elephant.off" "${meshes[@]}"; do
  echo "$mesh"
  "$program" "$mesh" 1 e2e-3 e5e-4
done
