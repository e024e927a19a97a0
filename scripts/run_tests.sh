#!/usr/bin/env bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Installs what is missing (packages of Debian), builds everything and runs all tests: those of the programs first, then those under
# sanitizers, libFuzzer and valgrind, then those of other compilers and versions of CGAL. In the end it prints how long each phase
# took.
# Usage: scripts/run_tests.sh [--all]
# --all also runs those labelled `long`, which the others cover in small. BUILD_DIR (default build/tests), JOBS (default 2),
# INSTRUMENTED=OFF, which leaves the last two kinds out, and FUZZING_SECONDS (default 0: on the same inputs each time), the time for
# each fuzzer, may be set in the environment.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh

build_dir=${BUILD_DIR:-build/tests}
jobs=${JOBS:-2}
instrumented=${INSTRUMENTED:-ON}
long_tests=OFF
case ${1:-} in
  '') ;;
  --all) long_tests=ON ;;
  *) sed -n "s/^# Usage: //p" scripts/run_tests.sh >&2 && exit 2 ;;
esac
kinds='address|thread|fuzz|memcheck'

install_packages_for_tests() {
  install_packages
  # python3 reads the JSON that hde_remesh writes, chromium its page
  install_missing doxygen libjs-mathjax chromium python3 libboost-mpi-dev openmpi-bin procps
  ! can_be_installed clang-format 14 || install_missing clang-format
  if [[ $instrumented == ON ]]; then
    # clang only recommends what programs under its sanitizers are linked with
    install_missing clang libclang-rt-dev valgrind
  fi
  unpack_cgal_data "$build_dir"
}

build() {
  cmake -Wno-dev -S . -B "$build_dir" -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=ON \
    -DCGAL_AHR_WITH_QUICK_COMPILATION=ON -DCGAL_AHR_WITH_COMPILED_LIBRARY=ON \
    -DCGAL_AHR_WITH_INSTRUMENTED_TESTS="$instrumented" -DCGAL_AHR_WITH_LONG_TESTS="$long_tests" \
    -DCGAL_AHR_FUZZING_SECONDS="${FUZZING_SECONDS:-0}"
  cmake --build "$build_dir" -j "$jobs"
}

run_ctest() {
  (cd "$build_dir" && ctest --output-on-failure --no-tests=error "$@")
}

trap print_phases EXIT
phase "packages" install_packages_for_tests
phase "build" build
status=0
phase "tests" run_ctest -j "$jobs" -LE "$kinds|elsewhere" || status=$?
if [[ $instrumented == ON ]]; then
  phase "under sanitizers, libFuzzer, valgrind" run_ctest -j "$jobs" -L "$kinds" || status=$?
  phase "other compilers and versions of CGAL" run_ctest -L elsewhere || status=$?
fi
exit $status
