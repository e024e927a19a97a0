#!/bin/bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# The page of hde_remesh --report in a browser without a screen: its scripts run, and show tables, histograms and both meshes.
#   test_report.sh PROGRAM CGAL_DATA_DIR CHROMIUM

if [ $# -ne 3 ] || [ ! -x "$1" ] || [ ! -d "$2/meshes" ] || [ ! -x "$3" ]; then
  echo "usage: $0 PROGRAM CGAL_DATA_DIR CHROMIUM" >&2
  exit 2
fi
program=$(realpath "$1")
data=$(realpath "$2")/meshes
browser=$3
folder=$(mktemp -d) || exit 2
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 2
export HOME=$folder # of the browser
passed=0
failed=0

check() {
  local name=$1
  shift
  if "$@"; then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    echo "failed: $name: $*"
  fi
}

# open PAGE: the page as its scripts leave it, in dom
open_page() {
  timeout 120 "$browser" --headless --no-sandbox --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader \
    --virtual-time-budget=20000 --dump-dom "file://$folder/$1" > dom 2> browser.log
}

contains() { grep -qF -- "$1" dom; }

# a name that would end the script, a tag and a quoted word
cp "$data/sphere.off" "it's <b> <!-- <script> mesh.off"
check "a page" "$program" "it's <b> <!-- <script> mesh.off" out.off --faces 800 --report page.html --quiet
check "it loads nothing from elsewhere" [ "$(grep -Eo '(src|href)=.?[^ ]*|@import|fetch\(|XMLHttpRequest' page.html | wc -l)" -eq 0 ]
check "a browser opens it" open_page page.html
check "both meshes are shown" contains 'data-state="shown"'
check "the name of the input" contains "it's &lt;b&gt; &lt;!-- &lt;script&gt; mesh.off"
check "the command line" contains "'it'\\''s &lt;b&gt; &lt;!-- &lt;script&gt; mesh.off'"
check "the table" contains 'triangles to the surface, root mean square'
check "its numbers" contains '<td>800</td>'
check "four histograms" [ "$(grep -o '<figure>' dom | wc -l)" -eq 4 ]
check "no number that is none" [ "$(grep -Ec 'NaN|undefined' <(sed '/<script type/,$d' dom))" -eq 0 ]
check "it is not simplified" [ "$(grep -c 'shown simplified to [0-9]' dom)" -eq 0 ]

# more triangles than a page shows
check "a page of many triangles" \
  "$program" "$data/sphere.off" large.off --faces 170000 --iterations 2 --no-distance --report large.html --quiet
check "it is no larger for it" [ "$(stat -c %s large.html)" -lt 20000000 ]
check "a browser opens it, too" open_page large.html
check "both meshes are shown again" contains 'data-state="shown"'
check "it says that it is simplified" grep -Eq 'after: 1[67][0-9],[0-9]{3} triangles; .*shown simplified to 1[45][0-9],[0-9]{3}' dom

# an embedding without 6D lengths has no histogram of them; degenerate faces have no aspect ratio
check "a page with a metric" "$program" "$data/sphere.off" metric.off --metric 2 --faces 800 --report metric.html --quiet
check "it opens" open_page metric.html
check "three histograms" [ "$(grep -o '<figure>' dom | wc -l)" -eq 3 ]

# by measured error there is no function: no row and no histogram of what it tells
check "a page by measured error" "$program" "$data/sphere.off" error.off --faces 200 --report error.html --quiet
check "it opens as well" open_page error.html
check "both meshes are shown here, too" contains 'data-state="shown"'
check "three histograms without 6D lengths" [ "$(grep -o '<figure>' dom | wc -l)" -eq 3 ]
check "of distances to the other mesh" contains '<figcaption>distance to the other mesh</figcaption>'
check "nothing to the surface" [ "$(grep -c 'triangles to the surface\|kernel\|sigma' <(sed '/<script type/,$d' dom))" -eq 0 ]
check "no number that is none in it" [ "$(grep -Ec 'NaN|undefined' <(sed '/<script type/,$d' dom))" -eq 0 ]

echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
