#!/usr/bin/env bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Fails if clang-tidy, with the checks of .clang-tidy, warns about a source file or this package's headers in it. It takes two to
# four minutes a file. Usage: scripts/check_tidy.sh [FILE...]; the default are the public headers and the program hde_remesh.
# BUILD_DIR (default build/tidy) and JOBS (default 2) may be set in the environment.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh

build_dir=${BUILD_DIR:-build/tidy}

install_packages
install_missing clang clang-tidy
cmake -Wno-dev -S . -B "$build_dir" -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DBUILD_TESTING=ON \
  -DCGAL_AHR_WITH_SHARED_COMPILATION=OFF
files=("$@")
if ((${#files[@]} == 0)); then
  # this header includes all others that are public but those named after it
  headers=$build_dir/test/Anisotropic_hde_remeshing/public_headers
  files=(examples/Anisotropic_hde_remeshing/hde_remesh/*.cpp)
  for header in anisotropic_hde_remeshing Curvature_metric Scalar_field_embedding approximation_bounds alignment_measures \
    distance_measures quality_measures transfer_vertex_property zero_set_measures; do
    files+=("$headers/include_$header.cpp")
  done
fi
printf '%s\0' "${files[@]}" |
  xargs -0 -n 1 -P "${JOBS:-2}" clang-tidy --quiet --warnings-as-errors='*' -p "$build_dir"
