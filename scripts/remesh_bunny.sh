#!/usr/bin/env bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Installs what is missing (packages of Debian), builds hde_remesh for this machine and remeshes CGAL's bunny.
# Usage: scripts/remesh_bunny.sh [OPTIONS OF hde_remesh]
# BUILD_DIR (default build/hde_remesh), OUTPUT (default bunny_remeshed.obj in it) and JOBS (default 2) may be set in the
# environment.

set -euo pipefail
# relative to where the user is, not to the repository
output=${OUTPUT:+$(realpath -m "$OUTPUT")}
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh

build_dir=${BUILD_DIR:-build/hde_remesh}
output=${output:-$(realpath -m "$build_dir")/bunny_remeshed.obj}

install_packages
unpack_cgal_data "$build_dir"
cmake -Wno-dev -S . -B "$build_dir" -DCMAKE_BUILD_TYPE=Release -DCGAL_AHR_NATIVE=ON -DBUILD_TESTING=OFF
cmake --build "$build_dir" --target hde_remesh -j "${JOBS:-2}"

program=$(find "$build_dir" -name hde_remesh -type f -perm -u+x)
"$program" "$(cgal_data_dir "$build_dir")/meshes/bunny00.off" "$output" "$@"
echo "The remeshed bunny: $output"
