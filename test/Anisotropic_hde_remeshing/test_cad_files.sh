#!/bin/bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# The program hde_remesh on files of CAD programs: tubes of long triangles, in OFF. It checks the number of faces, the largest
# distance both ways, and what is said. scripts/benchmark_files.sh does the same for many more shapes.
#   test_cad_files.sh PROGRAM

if [ $# -ne 1 ] || [ ! -x "$1" ]; then
  echo "usage: $0 PROGRAM" >&2
  exit 2
fi
program=$(realpath "$1")
folder=$(mktemp -d) || exit 2
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 2
passed=0
failed=0

# tube SIDES BANDS: of radii 1 and 0.7 and height 4, to the standard output
tube() {
  awk -v n="$1" -v k="$2" 'BEGIN {
    rings = 2 * (k + 1)
    printf "OFF\n%d %d 0\n", n * rings, 2 * n * rings
    for (r = 0; r < rings; ++r)
      for (i = 0; i < n; ++i) {
        radius = r <= k ? 1 : 0.7
        z = 4 * (r <= k ? r : 2 * k + 1 - r) / k
        printf "%.17g %.17g %.17g\n", radius * cos(2 * 3.14159265358979324 * i / n), radius * sin(2 * 3.14159265358979324 * i / n), z
      }
    for (r = 0; r < rings; ++r)
      for (i = 0; i < n; ++i) {
        j = (i + 1) % n
        s = (r + 1) % rings
        printf "3 %d %d %d\n3 %d %d %d\n", n * r + i, n * r + j, n * s + j, n * r + i, n * s + j, n * s + i
      }
  }'
}

# figure NAME: the last number of this name in the JSON
figure() { sed -n 's/.*"'"$1"'": \([-+0-9.e]*\).*/\1/p' figures.json | tail -1; }

# is TEST: whether it is true, in awk
is() { awk "BEGIN { exit !($1) }"; }

# check NAME CONDITION
check() {
  if is "$2"; then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    echo "failed: $1: $2"
    head -5 stderr
  fi
}

# run FILE FACES DISTANCE OPTIONS...: the number of faces within 2%, the largest distance, over the diagonal, at most this one
run() {
  local file=$1 faces=$2 distance=$3
  shift 3
  rm -f figures.json
  "$program" "$file" out.off --faces "$faces" --json figures.json "$@" >/dev/null 2>stderr
  check "status of $file $*" "$? == 0"
  local got max diagonal
  got=$(sed -n 2p out.off | cut -d ' ' -f 2) max=$(figure max) diagonal=$(figure diagonal)
  check "faces of $file $*" "${got:-0} >= 0.98 * $faces && ${got:-0} <= 1.02 * $faces"
  check "distance of $file $*" "${max:-1} <= $distance * ${diagonal:-0}"
}

tube 90 3 >tube_90.off
tube 12 3 >tube_12.off
run tube_90.off 1000 1e-9
run tube_90.off 1000 1e-9 --sharp 40
run tube_90.off 2000 1e-9
run tube_12.off 1000 1e-9
run tube_12.off 1000 1e-9 --sharp 40
run tube_12.off 150 8e-3
# an embedding keeps to the facets, each a region
for options in "--sharp 40 --metric 2" "--sharp 40 --sigma .02" "--metric 2" "--sigma .02" "--sharp 40 --sigma .02 --kernel gaussian"; do
  run tube_12.off 1000 1e-9 $options
  check "facets are regions with $options" "$(grep -c '"planes": 26,' figures.json) == 1 && $(grep -c '"regions": 26,' figures.json) == 2"
  check "an embedding with $options" "$(grep -c '"scheme": "embedding"' figures.json) == 1"
done
check "the kernel has no effect" "$(grep -c 'kernel has no effect: the facets of IN are exact' figures.json) == 1"
# with sides that are too narrow for it, the measured error leads, and that is told
for options in "--sharp 40 --metric 2" "--sigma .02"; do
  run tube_90.off 1000 1e-9 $options
  check "measured error with $options" "$(grep -c '"scheme": "measured-error"' figures.json) == 1"
  check "told with $options" "$(grep -c 'the measured error leads' figures.json) == 1"
done
# An embedding in any case: the vertices are on the facets, and edges cut across their edges, which is told. With a kernel it is its
# function.
run tube_90.off 1000 4e-2 --metric 2 --scheme embedding
check "an embedding on long facets is told" "$(grep -c 'by an embedding IN and OUT are up to' figures.json) == 1"
check "rounded creases are told" "$(grep -c 'D from OUT' figures.json) == 1"
check "the function is that of the facets" "$(grep -c '"closest_point_regions": 1' figures.json) == 1"
run tube_12.off 1000 8e-2 --metric 2 --kernel thin-plate
check "the function is that of the kernel" "$(grep -c 'closest_point_regions' figures.json) == 0"

echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
