#!/usr/bin/env bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Builds the benchmark of the implicit function for this machine and prints the table of its figures: of every kernel on an
# ellipsoid, and of CGAL's bunny00, armadillo, elephant and camel and the meshes given, accuracy, time, memory and sign.
# Usage: scripts/benchmark_implicit_function.sh [MESH[:FACES]...]
# FACES is to how many CGAL's isotropic_remeshing goes, to compare the times (default: those of the mesh): let nothing else
# run. For the Stanford bunny, say: scripts/benchmark_implicit_function.sh bunny.obj:110350
# BUILD_DIR (default build/benchmark), JOBS (default 2) and SECTIONS (default abcdef) may be set in the environment.

set -euo pipefail
# relative to where the user is, not to the repository
meshes=()
for argument in "$@"; do
  IFS=: read -r file faces <<< "$argument"
  meshes+=("$(realpath "$file")${faces:+:$faces}")
done
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh

build_benchmark benchmark_implicit_function
"$program" --sections "${SECTIONS:-abcdef}" "$data/bunny00.off" "$data/armadillo.off" "$data/elephant.off" \
  "$data/camel.off" "${meshes[@]}"
