#!/usr/bin/env bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Builds the benchmark of the time and the memory for this machine and runs it: CGAL's bunny00 and elephant and the meshes given
# beside CGAL's isotropic_remeshing, a million faces, growth from 20,000 to 2,000,000 faces, one thread against two, and the
# parts one by one. Prints the tables and writes them as CSV, with pictures of the growth, to RESULTS. Let nothing else run.
# Usage: scripts/benchmark.sh [MESH:FACES:SIGMA[:ASKED]...]
# SIGMA is a fraction of the diagonal, ASKED the ratio of the times that is asked for. For the Stanford bunny, say:
# scripts/benchmark.sh bunny.obj:39800:.02:1.0 bunny.obj:110350:.01:0.7
# BUILD_DIR (default build/benchmark), JOBS (default 2), RESULTS (default BUILD_DIR/results), SECTIONS (default
# cases,threads,million,growth) and LARGEST (of the growth, default 2000000 faces) may be set in the environment.

set -euo pipefail
# relative to where the user is, not to the repository
cases=()
for argument in "$@"; do
  cases+=("$(realpath "${argument%%:*}"):${argument#*:}")
done
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh

install_missing libbenchmark-dev gnuplot-nox
build_benchmark micro_benchmarks
build_benchmark benchmark_performance
results=${RESULTS:-$build_dir/results}
mkdir -p "$results"
"$program" --output "$results" --sections "${SECTIONS:-cases,threads,million,growth}" --largest "${LARGEST:-2000000}" \
  "$data/bunny00.off:75408:.01:0.9" "$data/refined_elephant.off:20000:.01:0.9" "${cases[@]}"
if [[ -f "$results/growth.csv" ]]; then
  gnuplot -e "results='$results'" benchmark/Anisotropic_hde_remeshing/Performance/growth.gnuplot
fi
"$(find "$build_dir" -name micro_benchmarks -type f -perm -u+x)" --benchmark_out="$results/parts.csv" \
  --benchmark_out_format=csv
echo "Tables and pictures: $results"
