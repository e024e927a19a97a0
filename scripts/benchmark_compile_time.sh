#!/usr/bin/env bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers
#
# Compiles the program of the README in Release and, to compare, one that only reads and writes a mesh by CGAL, three times each
# without a cache, and prints the seconds. Let nothing else run.
# Usage: scripts/benchmark_compile_time.sh
# BUILD_DIR (default build/benchmark) may be set in the environment.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh

export CCACHE_DISABLE=1 TIMEFORMAT='%R s'
for target in remesh_example read_and_write; do
  build_benchmark "$target" -DCGAL_AHR_WITH_SHARED_COMPILATION=OFF > /dev/null
  for run in 1 2 3; do
    find "$build_dir" -name "$target.cpp.o" -delete
    printf '%s, run %s: ' "$target" "$run"
    time cmake --build "$build_dir" --target "$target" > /dev/null
  done
done
