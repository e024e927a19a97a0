#!/usr/bin/env bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers
#
# Compiles the program of the README in Release and, to compare, the same with CGAL's isotropic_remeshing and one that only reads and
# writes a mesh by CGAL, RUNS times each without a cache: with the headers alone, and linked to the compiled library, which has been
# compiled before. Prints the least seconds of processor time and the compiler's memory, and their ratios to those of
# isotropic_remeshing. Then it compiles the program hde_remesh, as the first command of the README does.
# Usage: scripts/benchmark_compile_time.sh
# BUILD_DIR (default build/benchmark), RUNS (default 3) and JOBS (default 2) may be set in the environment.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh

export CCACHE_DISABLE=1
install_missing time

# compile TARGET: makes it again; prints seconds of processor time, megabytes of the largest process, and seconds
compile() {
  find "$build_dir" -path "*/$1.dir/*.o" -delete
  /usr/bin/time --quiet --format '%U %M %e' --output "$build_dir/compile_time.txt" \
    cmake --build "$build_dir" --target "$1" -j "${JOBS:-2}" > /dev/null 2>&1
  awk '{ printf "%.1f %.0f %.1f\n", $1, $2 / 1024, $3 }' "$build_dir/compile_time.txt"
}

printf '%-24s %14s %12s %8s %8s\n' program 'processor s' 'memory MB' ratio ratio
for target in remesh_isotropically read_and_write linked_remesh_example remesh_example; do
  build_benchmark "$target" -DCGAL_AHR_WITH_SHARED_COMPILATION=OFF -DCGAL_AHR_WITH_COMPILED_LIBRARY=ON > /dev/null 2>&1
  best=$(for ((run = 0; run < ${RUNS:-3}; ++run)); do compile "$target"; done | sort -n | head -n 1)
  read -r seconds memory _ <<< "$best"
  reference=${reference:-$best}
  awk -v name="$target" -v best="$seconds $memory" -v reference="$reference" 'BEGIN {
    split(best, b, " "); split(reference, r, " ")
    printf "%-24s %14s %12s %8.2f %8.2f\n", name, b[1], b[2], b[1] / r[1], b[2] / r[2] }'
done

build_dir=$build_dir/hde_remesh
cmake -Wno-dev -S . -B "$build_dir" -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=OFF > /dev/null
read -r seconds memory wall <<< "$(compile hde_remesh)"
echo "hde_remesh: $seconds s of processor time, $wall s, $memory MB"
