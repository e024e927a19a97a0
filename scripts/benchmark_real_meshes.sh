#!/usr/bin/env bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Remeshes CGAL's larger meshes, and those given, to a quarter, a tenth and a twenty-fifth of their vertices, in three settings and by
# CGAL's edge collapse. Prints a line of figures each: distances both ways, normals, shapes, folds, intersections and time; in the
# end the geometric means and the worst ones of all. See benchmark_real_meshes.cpp. About ten minutes.
# With --errors: to errors of 3e-3, 1e-3 and 3e-4 of the diagonal, and how many faces CGAL's collapse takes for each. An hour.
# Usage: scripts/benchmark_real_meshes.sh [--errors] [MESH...]
# BUILD_DIR (default build/benchmark) and JOBS (default 2) may be set in the environment.

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
options=()
if [[ "${1:-}" == --errors ]]; then
  options+=(--errors)
  shift
fi
absolute_paths "$@"
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build_benchmark benchmark_real_meshes
of_cgal=()
for name in armadillo bear bull bunny00 camel ChineseDragon-10kv dino diplodocus elephant homer lion-head lion man \
  mannequin-devil pig turbine; do
  for mesh in "$data/$name".*; do
    of_cgal+=("$mesh")
  done
done
"$program" "${options[@]}" "${of_cgal[@]}" "${meshes[@]}"
