#!/usr/bin/env bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Installs what is missing (packages of Debian), builds everything and runs all tests, those under sanitizers, libFuzzer and
# valgrind, and those of another compiler, last. Usage: scripts/run_tests.sh
# BUILD_DIR (default build/tests), JOBS (default 2), INSTRUMENTED=OFF, which leaves these out, and FUZZING_SECONDS
# (default 0: on the same inputs each time), the time for each fuzzer, may be set in the environment.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh

build_dir=${BUILD_DIR:-build/tests}
jobs=${JOBS:-2}

instrumented=${INSTRUMENTED:-ON}

install_packages
install_missing doxygen libjs-mathjax chromium clang-format
[[ $instrumented == OFF ]] || install_missing clang valgrind
unpack_cgal_data "$build_dir"
cmake -Wno-dev -S . -B "$build_dir" -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=ON \
  -DCGAL_AHR_WITH_INSTRUMENTED_TESTS="$instrumented" -DCGAL_AHR_FUZZING_SECONDS="${FUZZING_SECONDS:-0}"
SECONDS=0
cmake --build "$build_dir" -j "$jobs"
echo "Built in $SECONDS s"
cd "$build_dir"
status=0
ctest -j "$jobs" --output-on-failure --no-tests=error -LE 'address|thread|fuzz|memcheck|elsewhere' || status=$?
[[ $instrumented == OFF ]] || ctest --output-on-failure --no-tests=error -L 'address|thread|fuzz|memcheck|elsewhere' || status=$?
exit $status
