#!/bin/bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# What hde_remesh shows on a terminal: the verdict and the table, a line of progress in each long stage, what it says when it is
# cancelled.
#   test_terminal.sh PROGRAM CGAL_DATA_DIR

if [ $# -ne 2 ] || [ ! -x "$1" ] || [ ! -d "$2/meshes" ]; then
  echo "usage: $0 PROGRAM CGAL_DATA_DIR" >&2
  exit 2
fi
program=$(realpath "$1")
data=$(realpath "$2")/meshes
# shellcheck source=program_checks.sh
source "$(dirname "$0")/program_checks.sh"

# --------------------------------------------------------------------------------------------- the verdict and the table
is_narrow() { awk 'length($0) > 100 { exit 1 }' "$1"; }
verdict() { sed '/^$/,$d' stdout; }
lines_after_verdict() { awk '/^$/ { is_after = 1; next } is_after' stdout; }
verdict_has() { verdict | grep -Eq -- "$1"; }
has_at_most_15_lines() { lines_after_verdict | awk 'END { exit !(NR > 5 && NR <= 15) }'; }
length='[0-9.]+(e-[0-9]+)? D'

# is_told NAME ARGUMENTS...: the verdict comes first, and is short as all that follows
is_told() {
  local name=$1
  shift
  check "$name" run 0 "$@"
  check "$name: the files first" [ "$(head -1 stdout)" = "$1 -> $2" ]
  check "$name: the faces" verdict_has '^faces: +[0-9]+(, about [0-9]+ (at most )?were asked for)?; the input has [0-9]+$'
  check "$name: the distance to the input" verdict_has "^distance to the input: +$length root mean square, $length largest$"
  check "$name: and from it" verdict_has "^distance from the input: +$length root mean square, $length largest$"
  check "$name: the worst triangle" verdict_has '^worst triangle: +aspect ratio [0-9.e+]+ \(an equilateral triangle has 1\)'
  check "$name: the warnings" verdict_has '^warnings: +[A-Za-z0-9-]'
  check "$name: at most 15 lines after it" has_at_most_15_lines
  check "$name: in at most 100 columns" is_narrow stdout
}
cp "$data/elephant.off" "$data/fandisk.off" "$data/sphere.off" .
is_told "by measured error" elephant.off o.off --faces 1000
check "no warning is said to be none" verdict_has '^warnings: +none$'
cp stdout short
is_told "by embedding, all at once" fandisk.off o.off --faces 3000 --sigma .02 --sharp 30 --self-intersections --error .001
check "curves are in the table" grep -q '^corners ' stdout
check "the error" verdict_has '^error asked for: +0.001 D, (kept|not kept): '
is_told "with a warning" sphere.off o.off --faces 12
check "it is in the verdict" verdict_has '^warnings: +IN and OUT are up to 0\.[0-9]+ D apart$'
check "without distances" run 0 sphere.off o.off --faces 1000 --no-distance
check "they are not measured" verdict_has '^distance to the input: +not measured$'

check "all figures" run 0 elephant.off o.off --faces 1000 --sigma .02 --details
check "there are many more" [ "$(lines_after_verdict | wc -l)" -gt 30 ]
check "in at most 100 columns, too" is_narrow stdout
check "those of the function" [ "$(grep -Ec '^(function|self-check|projections|remeshing): ' stdout)" -eq 4 ]
check "all figures by measured error" run 0 elephant.off o.off --faces 1000 --details
check "those of the short table are among them" \
  awk 'NR == FNR { is_in[$0] = 1; next } /^$/ { is_after = 1 } is_after && $0 !~ /^(time|D = )/ && !($0 in is_in) { exit 1 }' stdout short
check "JSON has all figures without --details" run 0 elephant.off o.off --faces 1000 --json -
for key in program input before after distance seconds remeshing warnings topology aspect_ratio; do
  check "$key" grep -q "\"$key\"" stdout
done

# ------------------------------------------------------------------------------------------------ the line of the progress
if ! command -v script >/dev/null; then
  echo "no script of util-linux: the terminal is not tested"
  summary
  exit
fi
export SHELL=/bin/sh PROGRAM=$program

# on_terminal STATUS COMMAND: a line of sh in a terminal; all that it shows is in shown, a frame of a line a line
on_terminal() {
  script -qec "$2" typescript </dev/null >/dev/null
  local status=$?
  tr '\r' '\n' <typescript | grep -av '^Script ' | sed 's/\x1b\[K//g' >shown
  [ $status -eq "$1" ]
}
shows() { grep -Eq -- "$1" shown; }
# bar STAGE: a line that tells how far the stage is, and how long it will take
bar() { shows "^\[[#.]{30}\] [0-9]+ % $1, about [0-9]+ (s|min|h) left$"; }

# bunnies NUMBER: beside each other, of 75,408 faces each
bunnies() {
  awk -v number="$1" 'NR == 2 { n = $1; m = $2; print "OFF"; print n * number, m * number, 0; next }
    NR > 2 && NF == 3 { p[i++] = $0 } NR > 2 && NF == 4 { f[j++] = $0 }
    END { for (k = 0; k < number; ++k) for (i = 0; i < n; ++i) { split(p[i], c); print c[1] + 2 * k, c[2], c[3] }
          for (k = 0; k < number; ++k) for (j = 0; j < m; ++j) { split(f[j], c); print 3, c[2] + k * n, c[3] + k * n, c[4] + k * n } }' \
    "$data/bunny00.off"
}
bunnies 20 >many.off
{ sed '$d' many.off; echo "3 0 1 99999999"; } >wrong.off
check "a long file" on_terminal 1 '"$PROGRAM" wrong.off o.off'
check "reading it is seen" bar reading
bunnies 8 | awk 'NR == 2 { $1 += 3; $2 += 1; n = $1; print; next } NR == n - 1 { print; print "0 0 0\n1e200 0 0\n0 1e200 0"; next } { print }
  END { print 3, n - 3, n - 2, n - 1 }' >far.off
check "a mesh to repair, and then too large to compute with" on_terminal 1 '"$PROGRAM" far.off o.off --repair'
check "the repair is seen" bar repairing
check "why it is too large" shows "diagonal .*, with which nobody can compute"
cp "$data/bunny00.off" .
check "a function" on_terminal 0 '"$PROGRAM" bunny00.off o.vtp --faces 60000 --sigma .01 --arrays --self-intersections --report page.html'
for stage in "building the function" remeshing measuring "writing the page"; do
  check "$stage is seen" bar "$stage"
done
check "no stage is done before its end" [ "$(grep -c '100 %\|about 0 s' shown)" -eq 0 ]
check "the table is there" shows '^Euler characteristic +2 +2$'
check "no frame is wider than the terminal" awk '/%/ && length($0) > 79 { exit 1 }' shown
check "a large file to write" on_terminal 0 '"$PROGRAM" many.off o.vtp --faces 1600000 --scheme measured-error --arrays --no-distance'
check "writing it is seen" bar writing
check "a narrow terminal" on_terminal 0 'stty cols 40; "$PROGRAM" bunny00.off o.off --faces 60000 --sigma .01 --no-distance'
check "has a line" shows '^\[#+\.*\] [0-9]+ %'
check "which is no wider" awk '/^\[#/ && length($0) > 39 { exit 1 }' shown
check "quiet" on_terminal 0 '"$PROGRAM" bunny00.off o.off --faces 20000 --sigma .01 --quiet'
check "is quiet there, too" [ "$(grep -c . shown)" -eq 0 ]
check "warnings are in the verdict" on_terminal 0 '"$PROGRAM" sphere.off o.off --faces 12'
check "once" [ "$(grep -c 'D apart' shown)" -eq 1 ]

# ----------------------------------------------------------------------------------------------------------------- Ctrl-C
# cancelled_when CONDITION WHAT ARGUMENTS...: by SIGINT, as soon as the condition holds
cancelled_when() {
  local condition=$1 what=$2
  shift 2
  rm -f o.off
  bash -c 'set -m; condition=$1; shift; "$@" 2>stderr >stdout & while ! eval "$condition"; do sleep .05; done; kill -INT $!; wait $!' \
    - "$condition" "$program" "$@" 2>/dev/null
  check "status 130: $what" [ $? -eq 130 ]
  check "$what is the last line" [ "$(tail -1 stderr)" = "hde_remesh: cancelled; $what" ]
}
cancelled_when 'sleep .5' "nothing was written" many.off o.off --repair                   # reading or repairing
cancelled_when 'sleep .5' "nothing was written" bunny00.off o.off --sigma .01             # building the function
cancelled_when 'sleep 3' "nothing was written" bunny00.off o.off --iterations 100000      # remeshing
cancelled_when '[ -s o.off ]' "the mesh is written" bunny00.off o.off --faces 75000 --sigma .01 --iterations 1 # measuring
check "it is whole" run 0 o.off again.off --iterations 0 --no-distance

# on a terminal, over the line of the progress
check "cancelled on a terminal" on_terminal 130 'timeout --foreground -s INT 3 "$PROGRAM" bunny00.off o.off --iterations 100000; test $? -eq 124 && exit 130'
check "in the same words" shows '^hde_remesh: cancelled; nothing was written$'

summary
