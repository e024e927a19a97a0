#!/usr/bin/env bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# What the implicit function makes of noisy points, of outliers and of holes: of an ellipsoid, of CGAL's bunny, and of the meshes
# given. Prints four tables, see benchmark_points.cpp, for 10,000 and 40,000 points; the last one has meshes by one call, beside those
# of CGAL's Poisson reconstruction. About five minutes.
# Usage: scripts/benchmark_points.sh [MESH...]
# BUILD_DIR (default build/benchmark) and JOBS (default 2) may be set in the environment.

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
absolute_paths "$@"
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build_benchmark benchmark_points
for points in 10000 40000; do
  "$program" "$points" "$data/bunny00.off" "${meshes[@]}"
done
