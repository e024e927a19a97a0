#!/bin/bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# The program hde_remesh with files of points.
#   test_points_program.sh PROGRAM

if [ $# -ne 1 ] || [ ! -x "$1" ]; then
  echo "usage: $0 PROGRAM" >&2
  exit 2
fi
program=$(realpath "$1")
# shellcheck source=program_checks.sh
source "$(dirname "$0")/program_checks.sh"

has() { grep -Eq -- "$1" "$2"; }
is_closed_sphere() { has '^components +1 +1$' stdout && has '^boundary loops +0 +0$' stdout && has '^Euler characteristic +2 +2$' stdout; }
has_one_boundary() { has '^components +1 +1$' stdout && has '^boundary loops +1 +1$' stdout; }

# refuses TEXT ARGUMENTS...: the program fails with one line that contains the text, and writes nothing
refuses() {
  local text=$1
  shift
  echo "precious" >precious.off
  check "refused: $*" run 1 "$@" precious.off
  check "names '$text'" says "$text"
  check "old output untouched" grep -qx precious precious.off
}

# ellipsoid FORMAT: 2,000 points with normals on an ellipsoid of axes 1, 2, 1, as lines of x y z nx ny nz
ellipsoid() {
  awk 'BEGIN { srand(1)
    while (i < 2000) {
      x = 2 * rand() - 1; y = 2 * rand() - 1; z = 2 * rand() - 1; r = sqrt(x * x + y * y + z * z)
      if (r > 1 || r < .1) continue
      ++i; x /= r; y /= r; z /= r; n = sqrt(x * x + y * y / 4 + z * z)
      printf "%.9g %.9g %.9g %.9g %.9g %.9g\n", x, 2 * y, z, x / n, y / 2 / n, z / n } }'
}
nothing="--iterations 0 --no-distance --details"
ellipsoid >e.xyz
cut -d' ' -f1-3 e.xyz >bare.xyz

# ------------------------------------------------------------------------------------------------------------- formats
ply_header() { # FORMAT [PROPERTIES...]
  printf 'ply\nformat %s 1.0\nelement vertex 2000\nproperty double x\nproperty double y\nproperty double z\n' "$1"
  shift
  [ $# -eq 0 ] || printf 'property %s\n' "$@"
  printf 'end_header\n'
}
{ ply_header ascii "double nx" "double ny" "double nz"; cat e.xyz; } >e.ply
{ ply_header ascii; cat bare.xyz; } >bare.ply
{ printf 'NOFF\n2000 0 0\n'; cat e.xyz; } >e.off
{ printf 'OFF\n2000 0 0\n'; cat bare.xyz; } >bare.off
awk '{ print "vn", $4, $5, $6; print "v", $1, $2, $3 }' e.xyz >e.obj
{ printf '# a comment\n2000\n'; cat e.xyz; } >e.pwn
for format in xyz ply off obj pwn; do
  check "points of $format" run 0 e.$format o_$format.off $nothing
  check "$format is closed" is_closed_sphere
  check "it is told" says "IN has 2000 points and no faces"
  check "the normals of $format are read" [ "$(grep -c 'no normals' stderr)" -eq 0 ]
  check "the same mesh from $format" cmp o_xyz.off o_$format.off
done
for format in xyz ply off; do
  check "points without normals of $format" run 0 bare.$format b_$format.off $nothing --json b.json
  check "$format is closed" is_closed_sphere
  check "the estimation is told" says "IN has no normals: they are estimated"
  check "with the number that could not be oriented" says "; 0 points could not be oriented"
  check "also in the JSON" has '"normals_are_estimated": true' b.json
done
check "the mesh looks outward" awk 'NR == 2 { n = $1; m = $2 } NR > 2 && NF == 3 { ++i; x[i] = $1; y[i] = $2; z[i] = $3 }
  NF == 4 && $1 == 3 { a = $2 + 1; b = $3 + 1; c = $4 + 1
    v += x[a] * (y[b] * z[c] - z[b] * y[c]) - y[a] * (x[b] * z[c] - z[b] * x[c]) + z[a] * (x[b] * y[c] - y[b] * x[c]) }
  END { exit !(v / 6 > 8.2 && v / 6 < 8.5) }' b_xyz.off # 8.38
if command -v python3 >/dev/null; then
  for order in little big; do
    python3 - $order <<'P' >binary_$order.ply
import struct, sys
order = sys.argv[1]
out = sys.stdout.buffer
lines = [line.split() for line in open("e.xyz")]
names = ["x", "y", "z", "nx", "ny", "nz"]
head = "ply\nformat binary_%s_endian 1.0\nelement vertex %d\n" % (order, len(lines))
head += "".join("property double %s\n" % name for name in names) + "property uchar red\nproperty float heat\nend_header\n"
out.write(head.encode())
for words in lines:
    c = [float(word) for word in words]
    out.write(struct.pack(("<" if order == "little" else ">") + "6dBf", *c, 200, c[1]))
P
    check "binary points, $order endian" run 0 binary_$order.ply o.off $nothing
    check "the same mesh from them" cmp o_xyz.off o.off
    check "OFF has no place for colours, which is told" says "OUT has no place for colours"
  done
  head -c 100000 binary_little.ply >short.ply
  refuses "byte 99995: expected ny of vertex 1883 of 2000, but the file ends" short.ply
fi

# ------------------------------------------------------------------------------------------ the rest of the program
check "a number of faces" run 0 e.xyz f.ply --faces 600 --details --json f.json
check "it is met" has '^faces +[0-9]+ +600$' stdout
check "fewer facets for fewer faces" awk '$1 == "faces" { exit !($2 < 1500 && $2 >= 1000) }' stdout
check "what was found is in the table" has '^points: 2000, 0 without normal, 0 outliers' stdout
for key in '"number": 2000' '"outliers": 0' '"components": 1' '"holes_closed": 0' '"noise": ' '"spacing": 0\.'; do
  check "$key in the JSON" has "$key" f.json
done
check "an error" run 0 e.xyz f.off --error 2e-3 --no-distance
check "it is kept" grep -Eq '^error asked for: .*, kept: ' stdout
check "STL" run 0 e.xyz f.stl $nothing
check "quiet" run 0 e.xyz q.off $nothing --quiet
check "is quiet" [ ! -s stdout -a ! -s stderr ]
check "one thread" run 0 bare.xyz t.off $nothing --threads 1
check "the same mesh" cmp b_xyz.off t.off

# --------------------------------------------------------------------------------------------------- colours and fields
paste -d' ' e.xyz <(awk '{ print ($1 > 0 ? 255 : 10), 20, 30, $2 }' e.xyz) >data
{ ply_header ascii "double nx" "double ny" "double nz" "uchar red" "uchar green" "uchar blue" "float heat"; cat data; } >colours.ply
check "colours" run 0 colours.ply colours_out.ply --faces 800 --no-distance --json c.json
check "are bytes in OUT" grep -aq '^property uchar red' colours_out.ply
check "and numbers are numbers" grep -aq '^property double heat' colours_out.ply
check "which is in the JSON" has '"heat"' c.json
check "into VTP" run 0 colours.ply colours.vtp --faces 800 --no-distance
check "all of the vertices have the colour and the number of the nearest point" awk '
  /Name="/ { match($0, /Name="[^"]*"/); name = substr($0, RSTART + 6, RLENGTH - 7); i = 0; next }
  /^<\// { name = "" }
  name == "red" { red[i++] = $1 } name == "heat" { heat[i++] = $1 }
  name == "points" { ++number; if ($1 > .1 && red[i] != 255 || $1 < -.1 && red[i] != 10 || (heat[i] - $2) ^ 2 > .02) ++wrong; ++i }
  END { exit !(number > 300 && wrong == 0) }' colours.vtp
check "a field of points" run 0 colours.ply field.off --field heat --faces 1500 --no-distance --details
check "is in the embedding" grep -q 'field heat' stdout
refuses "no property 'cold'" colours.ply --field cold
awk '{ print $1, $2, $3, 200, 20, 30, $7 }' data >colours.xyz
check "XYZ with colours in the place of normals" run 0 colours.xyz xyz_colours.ply $nothing
check "which are known by their values" says "IN has no normals"
check "and carried" grep -aq '^property uchar blue' xyz_colours.ply
check "the same file has as many columns more" grep -aq '^property double column_7' xyz_colours.ply

# -------------------------------------------------------------------------------------------------------------- holes
awk '$2 < 1.2' e.xyz >cap.xyz
check "a cap missing" run 0 cap.xyz closed.off $nothing
check "is closed" is_closed_sphere
check "which is told" says "1 hole, closed"
check "trimmed" run 0 cap.xyz trimmed.off $nothing --trim .2 --json trim.json
check "it has one boundary, and no component more" has_one_boundary
check "no face is degenerate or folded" has '^(degenerate faces|folded edges) +0 +0$' stdout
check "the distance is in the JSON" has '"distance": 0.2' trim.json
# the boundary is .2 from the nearest point, but for the chords; else vertices are nearer
check "the boundary is clean" awk 'NR == FNR { x[++n] = $1; y[n] = $2; z[n] = $3; next }
  FNR > 2 && NF == 3 { px[k] = $1; py[k] = $2; pz[k] = $3; ++k }
  NF == 4 && $1 == 3 { for (j = 0; j < 3; ++j) ++e[$(2 + j) "," $(2 + (j + 1) % 3)] }
  END { for (i in e) { split(i, ends, ","); if (!((ends[2] "," ends[1]) in e)) b[ends[1]] = 1 }
    for (v in b) { ++number; least = 1e9
      for (j = 1; j <= n; ++j) { d = (px[v] - x[j]) ^ 2 + (py[v] - y[j]) ^ 2 + (pz[v] - z[j]) ^ 2; if (d < least) least = d }
      if ((sqrt(least) - .2) ^ 2 > 1e-8) ++wrong }
    exit !(number > 10 && wrong == 0) }' cap.xyz trimmed.off
check "trimmed and remeshed" run 0 cap.xyz t.ply --trim .2 --faces 1000
check "it has the boundary still" has_one_boundary
check "less than two spacings" run 0 cap.xyz t.off $nothing --trim .08
check "has a warning" says "less than two spacings"
refuses "--trim must be a finite number above 0, not 0" e.xyz --trim 0

# -------------------------------------------------------------------------------------- components, noise, and outliers
{ cat e.xyz; awk '{ print .5 * $1 + 5, .5 * $2, .5 * $3, $4, $5, $6 }' e.xyz | awk 'NR % 4 == 0'; } >two.xyz
check "two components" run 0 two.xyz two.off $nothing
check "both are made" has '^components +2 +2$' stdout
check "the largest" run 0 two.xyz largest.off $nothing --keep-largest --json largest.json
check "is kept" is_closed_sphere
check "the other is counted" has '"removed_components": 1' largest.json
check "it is the larger one" awk 'NR > 2 && NF == 3 && $1 > 2 { ++wrong } END { exit wrong > 0 }' largest.off
cut -d' ' -f1-3 two.xyz >two_bare.xyz
check "two components without normals" run 0 two_bare.xyz two.off $nothing
check "all of which are oriented" says "; 0 points could not be oriented"
check "both are there" has '^components +2 +2$' stdout
check "neither is in the other" has '^Euler characteristic +4 +4$' stdout
{ cat e.xyz; awk 'BEGIN { srand(2); for (i = 0; i < 40; ++i) print 4 * rand() - 2, 4 * rand() - 2, 4 * rand() - 2, 0, 0, 1 }'; } >dirty.xyz
check "outliers" run 0 dirty.xyz dirty.off $nothing --json dirty.json
check "are left out" is_closed_sphere
check "and counted" has '"outliers": (3[0-9]|40),' dirty.json
awk 'BEGIN { srand(3) } { for (k = 1; k <= 3; ++k) $k += .03 * (rand() - .5); print }' e.xyz >noisy.xyz
check "noise" run 0 noisy.xyz noisy.off $nothing --json noisy.json
check "is found by itself" has '"noise": 0.0(0[6-9]|1[01])' noisy.json
check "without smoothing" run 0 noisy.xyz rough.off $nothing --smoothing 0 --json rough.json
check "there is none" has '"noise": 0.0,' rough.json
refuses "--trim 1e-09 leaves nothing" noisy.xyz --trim 1e-9
check "noise that was removed does not keep the error from leading" run 0 noisy.xyz n.off --smoothing auto --faces 500 --no-distance --details
check "by which it goes" grep -q 'by measured error' stdout
awk '{ print $1, $2, $3, 0, 0, 0 }' e.xyz >zero.xyz
check "normals that are zero" run 0 zero.xyz zero.off $nothing
check "are estimated" says "IN has no normals"
awk 'NR % 10 { print; next } { print $1, $2, $3, "nan", 0, 0 }' e.xyz >some.xyz
check "some normals that are no numbers" run 0 some.xyz some.off $nothing
check "are told" says "200 points of IN have no normal"

# ---------------------------------------------------------------------------------------------------------- wrong files
refuses "missing.xyz" missing.xyz
: >empty.xyz
refuses "cannot read 'empty.xyz': it is empty" empty.xyz
printf '# no more than this\n' >comment.xyz
refuses "it is cut off: line 1: expected the coordinates of a point, but the file ends" comment.xyz
printf '1 2 3\n1 2\n' >two_numbers.xyz
refuses "line 2: expected 3 numbers, as before, found 2" two_numbers.xyz
printf '1 2\n' >flat.xyz
refuses "line 1: expected three coordinates, found 2" flat.xyz
printf '# x y z\n1 2 3\n1 X 3\n' >word.xyz
refuses "line 3: expected a number, a coordinate of point 2, found 'X'" word.xyz
printf '1 2 3\n1 nan 3\n' >nan.xyz
refuses "line 2: 'nan' is not a finite number" nan.xyz
printf '1 2 3 a b c\n' >word_normal.xyz
refuses "line 1: expected a number, found 'a'" word_normal.xyz
{ printf '3000\n'; cat e.xyz; } >count.xyz
refuses "expected 3000 points" count.xyz
head -c 3000 /dev/urandom >noise.xyz
refuses "noise.xyz" noise.xyz
head -5 e.xyz >few.xyz
refuses "it has 5 points and no faces: too few" few.xyz
awk 'BEGIN { for (i = 0; i < 50; ++i) print 1, 2, 3, 0, 0, 1 }' >same.xyz
refuses "diagonal 0.000000" same.xyz
head -1500 e.ply >cut.ply
refuses "line 15" cut.ply
sed 's/element vertex 2000/&\nproperty long w/' e.ply >type.ply
refuses "line 4: no property of a known type" type.ply
sed '12s/.*/1 2 3 4 5/' e.ply >words.ply
refuses "line 12: expected nz of vertex" words.ply
sed '5s/.*/1 2 3/' e.off >normal.off
refuses "line 5: expected a normal of vertex 3 of 2000" normal.off
{ printf 'ply\nformat ascii 1.0\nelement vertex 20\nproperty float x\nproperty float y\nproperty float z\nelement tristrips 1\n'
  printf 'property list int int vertex_indices\nend_header\n'; head -20 bare.xyz; echo 3 0 1 2; } >strips.ply
refuses "expected an element face in the place of tristrips" strips.ply
cp e.xyz e.las
refuses "LASlib" e.las
refuses "--repair is for meshes" e.xyz --repair
refuses "--merge is for meshes" e.xyz --merge .1
for option in "--trim .1" --keep-largest --keep-outliers; do
  refuses "${option% *} is for points" o_xyz.off $option
done

summary
