#!/usr/bin/env bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Installs what is missing (packages of Debian), builds everything and runs all tests. Usage: scripts/run_tests.sh
# BUILD_DIR (default build/tests) and JOBS (default 2) may be set in the environment.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh

build_dir=${BUILD_DIR:-build/tests}
jobs=${JOBS:-2}

install_packages
unpack_cgal_data "$build_dir"
cmake -Wno-dev -S . -B "$build_dir" -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=ON
SECONDS=0
cmake --build "$build_dir" -j "$jobs"
echo "Built in $SECONDS s"
cd "$build_dir"
ctest --output-on-failure --no-tests=error
