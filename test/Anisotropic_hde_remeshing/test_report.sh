#!/bin/bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# The page of hde_remesh --report in a browser without a screen: its scripts run, and show tables, histograms and both meshes. Then
# report_page_checks.js uses it by mouse, fingers and keys, on a desk and on a phone.
#   test_report.sh PROGRAM CGAL_DATA_DIR CHROMIUM

if [ $# -ne 3 ] || [ ! -x "$1" ] || [ ! -d "$2/meshes" ] || [ ! -x "$3" ]; then
  echo "usage: $0 PROGRAM CGAL_DATA_DIR CHROMIUM" >&2
  exit 2
fi
program=$(realpath "$1")
data=$(realpath "$2")/meshes
browser=$3
uses=$(realpath "$(dirname "$0")")/report_page_checks.js
# shellcheck source=program_checks.sh
source "$(dirname "$0")/program_checks.sh"

export HOME=$folder # of the browser

# open PAGE: the page as its scripts leave it, in dom
open_page() {
  timeout 120 "$browser" --headless --no-sandbox --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader \
    --enable-logging=stderr --window-size=1400,1000 --virtual-time-budget=60000 --dump-dom "file://$folder/$1" > dom 2> browser.log
}

console_is_empty() {
  if grep CONSOLE browser.log; then
    return 1
  fi
}

# use_page NAME PAGE WIDTH HEIGHT: the checks of report_page_checks.js in a window of that size. It is a frame, as windows of
# browsers are no narrower than 500 pixels.
use_page() {
  { sed '/^<\/body>$/,$d' "$2"; echo '<script>'; cat "$uses"; echo '</script></body></html>'; } > used.html
  cat > frame.html << END
<!DOCTYPE html>
<body><pre id="results"></pre><pre id="obj"></pre><iframe src="used.html" width="$3" height="$4"></iframe>
<script>
addEventListener("message", e => { for (const id of ["results", "obj"]) document.getElementById(id).textContent = e.data[id]; });
</script></body>
END
  check "$1: a browser opens it" open_page frame.html
  check "$1: the console is empty" console_is_empty
  check "$1: the checks come to their end" contains 'end of the checks'
  local line
  while read -r line; do
    check "$1: $line" [ "${line%%:*}" = ok ]
  done < <(grep -Eo '(ok|FAILED): .*' dom)
}

# is_saved_mesh OFF: whether the OBJ file that the page saves, which `use_page` leaves in dom, is that mesh to 2e-7 of coordinates
# that are at most 1
is_saved_mesh() {
  awk 'FNR == NR { if (FNR == 2) n = $1; if (FNR > 2 && FNR <= n + 2) points[FNR - 2] = $0;
                   if (FNR > n + 2 && NF > 3) faces[++m] = $2 + 1 " " $3 + 1 " " $4 + 1; next }
       { sub(/<pre id="obj">/, "\n"); sub(/.*\n/, "") }
       $1 == "v" { split(points[++v], p); for (i = 1; i <= 3; ++i) if ((p[i] - $(i + 1)) ^ 2 > 4e-14) exit 1 }
       $1 == "f" { sub(/^f /, ""); if (faces[++f] != $0) exit 1 }
       END { exit !(v == n && f == m && n > 3) }' <(grep . "$1") dom
}

# the table on the terminal, and that of the page, a line each: name|before|after
rows_of_terminal() { awk '/^$/ { is_table = 0 } is_table { print } /^ +before +after$/ { is_table = 1 }' stdout | sed -E 's/ {2,}/|/g'; }
# the verdict on the terminal, each of its texts in one line, and that of the page
verdict_of_terminal() {
  awk 'NR == 1 { next } /^$/ { exit } /^ / { sub(/^ +/, ""); line = line " " $0; next }
       { if (line) print line; sub(/: +/, "|"); line = $0 } END { print line }' stdout
}
verdict_of_page() {
  grep -Eo '<table id="verdict">.*</table>' dom | sed 's|</table>.*||; s|</tr>|\n|g; s|</td><td>|\||g; s|<[^>]*>||g' | grep '|'
}
is_verdict_alike() { diff <(verdict_of_terminal) <(verdict_of_page) > /dev/null && [ "$(verdict_of_page | wc -l)" -ge 5 ]; }
rows_of_page() {
  grep -Eo '<table id="measures">.*</table>' dom | sed 's|</table>.*||; s|</tr>|\n|g; s|</td><td>|\||g; s|<[^>]*>||g' | grep '|'
}
are_tables_alike() { diff <(rows_of_terminal) <(rows_of_page) > /dev/null && [ "$(rows_of_page | wc -l)" -gt 12 ]; }

contains() { grep -qF -- "$1" dom; }

# a name that would end the script, a tag and a quoted word
cp "$data/sphere.off" "it's <b> <!-- <script> mesh.off"
check "a page" "$program" "it's <b> <!-- <script> mesh.off" out.off --faces 800 --sigma .02 --details --report page.html > stdout 2> /dev/null
check "it loads nothing from elsewhere" \
  [ "$(grep -Eo '(src|href)=.?[^ ]*|@import|fetch\(|XMLHttpRequest' page.html | wc -l)" -eq 0 ]
check "a browser opens it" open_page page.html
check "both meshes are shown" contains 'data-state="shown"'
check "the name of the input" contains "it's &lt;b&gt; &lt;!-- &lt;script&gt; mesh.off"
check "the command line" contains "'it'\\''s &lt;b&gt; &lt;!-- &lt;script&gt; mesh.off'"
check "the table is that of the terminal" are_tables_alike
check "so is the verdict" is_verdict_alike
check "the distance to the zero set in D" grep -Eq '<td>faces to the zero set, rms</td><td>[-0-9.e]+ D</td><td>[-0-9.e]+ D</td>' dom
check "its numbers" contains '<td>800</td>'
check "five histograms" [ "$(grep -o '<figure>' dom | wc -l)" -eq 5 ]
check "the console is empty" console_is_empty
check "no number that is none" [ "$(grep -Ec 'NaN|undefined' <(sed '/<script type/,$d' dom))" -eq 0 ]
check "it is not simplified" [ "$(grep -c 'shown simplified to [0-9]' dom)" -eq 0 ]

use_page "on a desk" page.html 1280 900
check "the mesh that it saves is that of the file" is_saved_mesh out.off
use_page "on a phone" page.html 390 844

# creases and boundaries
check "a page of a mesh with creases" \
  "$program" "$data/fandisk.off" sharp.off --faces 2000 --sharp 20 --details --report sharp.html > stdout 2> /dev/null
check "it opens, too" open_page sharp.html
check "regions, curves and corners as on the terminal" are_tables_alike
check "they are there" grep -Eq '<td>regions between creases</td><td>[0-9]+</td>.*<td>corners</td><td>[1-9][0-9]*</td>' dom
check "no length in the unit of the mesh" grep -Eq '<td>length of the feature curves</td><td>[0-9.]+ D</td>' dom
use_page "creases, on a desk" sharp.html 1280 900
use_page "creases, on a phone" sharp.html 390 844

# parts that hide others
check "a page of a knot" "$program" "$data/knot1.off" knot.off --faces 1000 --report knot.html --quiet
use_page "knot" knot.html 1280 900
check "a hidden triangle was found" contains 'what hides a triangle is cut away'

# more triangles than a page shows
check "a page of many triangles" \
  "$program" "$data/sphere.off" large.off --faces 170000 --iterations 2 --no-distance --report large.html --quiet
check "a browser opens it, too" open_page large.html
check "both meshes are shown again" contains 'data-state="shown"'
check "it says that it is simplified" grep -Eq 'after: 1[67][0-9],[0-9]{3} triangles; .*shown simplified to 1[45][0-9],[0-9]{3}' dom
shown=$(grep -Eo 'shown simplified to [0-9,]+' dom | head -1 | tr -dc 0-9)
check "two meshes of 100,000 triangles take less than 5 MB" [ $(($(stat -c %s large.html) * 200000 / ${shown:-1})) -lt 5000000 ]

# an embedding without 6D lengths has no histogram of them; degenerate faces have no aspect ratio
check "a page with a metric" "$program" "$data/sphere.off" metric.off --metric 2 --faces 800 --report metric.html --quiet
check "it opens" open_page metric.html
check "four histograms" [ "$(grep -o '<figure>' dom | wc -l)" -eq 4 ]

check "a page with sigma by the curvature" \
  "$program" "$data/sphere.off" auto.off --sigma auto --faces 800 --report auto.html --quiet
check "it opens, as the others" open_page auto.html
check "sigma is told as it is" contains '<td>sigma 1 / sqrt|K|</td>'
check "no number that is none there" [ "$(grep -Ec 'NaN|undefined' <(sed '/<script type/,$d' dom))" -eq 0 ]

# by measured error there is no function: no row and no histogram of what it tells
check "a page by measured error" "$program" "$data/sphere.off" error.off --faces 200 --report error.html --quiet
check "it opens as well" open_page error.html
check "both meshes are shown here, too" contains 'data-state="shown"'
check "three histograms without 6D lengths" [ "$(grep -o '<figure>' dom | wc -l)" -eq 3 ]
check "of distances to the other mesh" contains '<figcaption>signed distance to the other mesh</figcaption>'
check "nothing to the surface" [ "$(grep -c 'zero set\|kernel\|sigma' <(sed '/<script type/,$d' dom))" -eq 0 ]
check "no number that is none in it" [ "$(grep -Ec 'NaN|undefined' <(sed '/<script type/,$d' dom))" -eq 0 ]

summary
