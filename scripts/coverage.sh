#!/usr/bin/env bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Prints which share of the lines of include/ the tests run, file by file, and fails below 90%. Installs what is missing (packages
# of Debian) and builds the tests once more, with g++'s counters. Usage: scripts/coverage.sh
# BUILD_DIR (default build/coverage) and JOBS (default 2) may be set in the environment.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh

build_dir=${BUILD_DIR:-build/coverage}
least=90

install_packages
install_missing gcovr
unpack_cgal_data "$build_dir"
cmake -Wno-dev -S . -B "$build_dir" -DCMAKE_CXX_COMPILER=g++ -DCMAKE_BUILD_TYPE=None -DBUILD_TESTING=ON \
  -DCMAKE_CXX_FLAGS='-O1 -DNDEBUG --coverage -fprofile-update=atomic' -DCGAL_AHR_WITH_EXAMPLES=OFF \
  -DCGAL_AHR_WITH_SHARED_COMPILATION=OFF
cmake --build "$build_dir" -j "${JOBS:-2}"
find "$build_dir" -name '*.gcda' -delete
# all but those of the installation and of CGAL's data, which run no other lines
(cd "$build_dir" && ctest --output-on-failure --no-tests=error -E 'test_rbf_corpus|install|include_order')
# one file's counters of all tests are added up; branches of templates say little
gcovr --root . --filter include/ --exclude-throw-branches --gcov-ignore-parse-errors --sort-percentage \
  --fail-under-line "$least" "$build_dir"
