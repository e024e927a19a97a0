#!/usr/bin/env bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers
#
# Holds the results for meshes of all kinds against what the package promises: CGAL's data, generated shapes and the meshes or
# folders given, each with many weights and numbers of faces, in a process of its own. Prints a line a mesh, each case that
# fails, and `N passed, N failed`; the exit status is 0 if none failed.
# Usage: scripts/benchmark_robustness.sh [MESH|FOLDER...]
# QUICK=1 tries six cases a mesh instead of 30; SECONDS_A_MESH (default 1800) bounds the time of a mesh. BUILD_DIR (default
# build/benchmark) and JOBS (default 2) may be set in the environment, too.

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
absolute_paths "$@"
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build_benchmark benchmark_robustness
mapfile -t cases < <("$program" --list)
while IFS= read -r -d '' file; do
  cases+=("$file")
done < <(find "${meshes[@]}" "$data" -type f \( -name '*.off' -o -name '*.obj' -o -name '*.ply' -o -name '*.stl' \) -print0 | sort -z)

log=$(mktemp)
trap 'rm -f "$log"' EXIT
for mesh in "${cases[@]}"; do
  status=0
  timeout "${SECONDS_A_MESH:-1800}" "$program" ${QUICK:+--quick} "$mesh" > "$log.one" 2>&1 || status=$?
  grep -v ' passed, ' "$log.one" || true
  if ((status > 1)); then
    echo "FAILED $mesh: exit status $status"
    echo "0 passed, 1 failed (0 valid, 0 refused, 0 left out)" >> "$log"
  else
    grep ' passed, ' "$log.one" >> "$log"
  fi
done
rm -f "$log.one"
awk '{ gsub(/[(]/, ""); passed += $1; failed += $3; valid += $5; refused += $7; left_out += $9 }
     END { printf "%d passed, %d failed (%d valid, %d refused, %d left out)\n", passed, failed, valid, refused, left_out
           exit failed > 0 }' "$log"
