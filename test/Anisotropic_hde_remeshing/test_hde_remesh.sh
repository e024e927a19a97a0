#!/bin/bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# The program hde_remesh as a user of a shell meets it.
#   test_hde_remesh.sh PROGRAM CGAL_DATA_DIR

if [ $# -ne 2 ] || [ ! -x "$1" ] || [ ! -d "$2/meshes" ]; then
  echo "usage: $0 PROGRAM CGAL_DATA_DIR" >&2
  exit 2
fi
program=$(realpath "$1")
data=$(realpath "$2")/meshes
# shellcheck source=program_checks.sh
source "$(dirname "$0")/program_checks.sh"

has_one_line() { [ "$(wc -l <stderr)" -eq 1 ] && grep -q '^hde_remesh: ' stderr && [ ! -s stdout ]; }
is_free_of_control_characters() { ! grep -q '[[:cntrl:]]' "$1"; }
has_no_temporary_file() { [ -z "$(ls -A "${1:-.}" | grep '^\.hde_remesh')" ]; }

# refuses STATUS TEXT ARGUMENTS...: the program fails with the status and one line that contains the text, and neither
# writes nor changes a file
refuses() {
  local status=$1 text=$2
  shift 2
  echo "precious" >precious.off
  cp precious.off precious.json
  local before after
  before=$(ls -A . | grep -v '^std')
  check "status $status" run "$status" "$@"
  check "one line" has_one_line
  check "names '$text'" says "$text"
  check "old output untouched" grep -qx precious precious.off
  check "old report untouched" grep -qx precious precious.json
  after=$(ls -A . | grep -v '^std')
  check "no file more or less: $*" [ "$before" = "$after" ]
}

# ---------------------------------------------------------------------------------------------------- help and version
is_narrow() { awk 'length($0) > 100 { exit 1 }' "$1"; }
has_words() { # FILE WORD...
  local file=$1 word
  shift
  for word in "$@"; do
    grep -Eq -- "(^|[ (])$word( |,|\$)" "$file" || return 1
  done
}
basic_options="--faces --vertices --length --error --fit --sigma --sharp --repair --trim --report --json --details --quiet -q --help-all --version"
check "help" run 0 --help
check "in at most 60 lines" [ "$(wc -l <stdout)" -le 60 ]
check "of at most 100 columns" is_narrow stdout
check "with the basic options" has_words stdout $basic_options
check "and nothing for experts" [ "$(grep -Ec -- '--(kernel|patches|collapse-ratio|tau)' stdout)" -eq 0 ]
check "D is said to be the diagonal before it is used" awk '
  /^D .*diagonal of the bounding box/ { is_defined = 1 } /[^A-Z]D([^A-Z]|$)/ { if (!is_defined) exit 1 } END { exit !is_defined }' stdout
check "with three examples or more" [ "$(grep -c '^  hde_remesh ' stdout)" -ge 3 ]
check "help explains the exit status" grep -q "Exit status" stdout
check "all of the help" run 0 --help-all
check "it is as narrow" is_narrow stdout
check "D is said before, there, too" awk '
  /^D .*diagonal of the bounding box/ { is_defined = 1 } /[^A-Z]D([^A-Z]|$)/ { if (!is_defined) exit 1 } END { exit !is_defined }' stdout
check "with all options" has_words stdout $basic_options --kernel --patches --collapse-ratio --tau --keep-largest --allow-self-intersections
check "no arguments" run 2
check "the usage in a few lines" [ "$(wc -l <stderr)" -le 5 -a ! -s stdout ]
check "that say what to do" says "usage: hde_remesh IN OUT"
check "version" run 0 --version
check "version in one line" [ "$(wc -l <stdout)" -eq 1 ]
quick="--iterations 2 --no-distance --details"

# ------------------------------------------------------------------------------------------- formats, in and out of each
for format in off obj ply stl; do
  check "write $format" run 0 "$data/sphere.off" sphere.$format --faces 1000 $quick
  check "$format is there" [ -s sphere.$format ]
done
for format in off obj ply stl; do
  check "read $format" run 0 sphere.$format again_$format.off $quick
  check "table of $format" grep -Eq '^Euler characteristic +2 +2$' stdout
  check "no fold from $format" grep -Eq '^folded faces +[0-9]+ +0$' stdout
done
check "upper case" run 0 "$data/sphere.off" UPPER.PLY --faces 500 $quick
cp sphere.obj UPPER.OBJ
check "upper case in" run 0 UPPER.OBJ upper.off $quick
check "the data's STL" run 0 "$data/sphere.stl" data_stl.off $quick
check "the data's PLY" run 0 "$data/sphere.ply" ply.off $quick
tr ' ' '\t' <sphere.obj >tabs.obj
check "OBJ with tabs" run 0 tabs.obj tabs.off $quick
# byte order marks; the header of a binary STL file may begin with the same bytes
for format in off obj; do
  { printf '\xEF\xBB\xBF'; cat sphere.$format; } >mark.$format
  check "$format with a byte order mark" run 0 mark.$format mark_$format.off --iterations 0 --no-distance
  check "it has all vertices" [ "$(awk '$1 == "vertices" { print $2 }' stdout)" -eq "$(grep -c '^v ' sphere.obj)" ]
done
if command -v iconv >/dev/null; then
  { printf '\xFF\xFE'; iconv -f ASCII -t UTF-16LE sphere.off; } >utf16.off
  { printf '\xFE\xFF'; iconv -f ASCII -t UTF-16BE sphere.obj; } >utf16.obj
  for format in off obj; do
    check "$format in UTF-16" run 0 utf16.$format mark_$format.off --iterations 0 --no-distance
    check "it has all vertices, too" [ "$(awk '$1 == "vertices" { print $2 }' stdout)" -eq "$(grep -c '^v ' sphere.obj)" ]
  done
fi
{ printf '\xFF\xFE'; tail -c +3 sphere.stl; } >mark.stl
check "a binary STL file that begins so" run 0 mark.stl mark_stl.off $quick
check "is read as it is" grep -Eq '^Euler characteristic +2 +2$' stdout
check "in place" run 0 tabs.off tabs.off $quick

# ------------------------------------------------------------------------------------------------------------- options
sphere=sphere.off
check "vertices" run 0 $sphere v.off --vertices 800 --iterations 5 --no-distance
check "their number is about right" awk '$1 == "vertices" { exit !($3 > 720 && $3 < 880) }' stdout
check "length" run 0 $sphere l.off --length 0.2 --absolute-sigma 0.05 $quick
check "thin plate" run 0 $sphere t.off --kernel thin-plate --patches 30 --overlap 2.5 --offset 0.01 $quick
for kernel in gaussian multiquadric inverse-multiquadric wendland-c2 wendland-c4 wendland-c6; do
  check "$kernel" run 0 $sphere k.off --kernel $kernel --shape 2.5 --smoothing 1e-6 $quick
done
check "smoothing" run 0 $sphere k.off --smoothing 0.01 $quick --json w.json
check "is told" grep -q "^noise of the vertices" stdout
check "also in the JSON" grep -q '"noise": 0.01' w.json
check "estimated noise" run 0 $sphere k.off --smoothing auto $quick --json w.json
check "of an exact sphere is none" grep -Eq '"noise": 0(\.0)?,' w.json
check "constants" run 0 $sphere c.off $quick --smoothing-ratio 0.5 --collapse-ratio 0.7 --split-ratio 1.4 \
  --relaxation-steps 2
check "scheme of the paper" run 0 $sphere p.off --scheme paper $quick
check "metric" run 0 $sphere m.off --metric 2 --faces 1500 --fit --no-distance --details
check "it is named" grep -q 'metric of the curvature, p = 2' stdout
check "no 6D lengths in it" [ "$(grep -c '6D' stdout)" -eq 0 ]
check "metric inf" run 0 $sphere mi.off --metric inf $quick
check "sharp" run 0 "$data/fandisk.off" sharp.ply --sharp 30 --faces 6000 --arrays --no-distance --details --json sharp.json
for name in "regions between creases" "feature curves, boundaries included" "corners"; do
  check "$name: as before, and more than one" awk -v name="$name" \
    'index($0, name) == 1 { found = $(NF - 1) == $NF && $NF > 1 } END { exit !found }' stdout
done
check "the curves are as long" awk '/^length of the feature curves/ { r = $(NF - 1) / $(NF - 3) } END { exit !(r > .999 && r < 1.001) }' stdout
check "no sharp fold" grep -Eq '^folded edges +0 +0$' stdout
check "sharp in the JSON" grep -q '"sharp": 30' sharp.json
check "without an angle there is one region" grep -Eq '"regions": 1,' <("$program" $sphere s.off $quick --json -)
check "sharp with a metric, fitted, by another kernel" run 0 "$data/fandisk.off" sm.off --sharp 40 --metric 2 --fit \
  --kernel wendland-c4 --faces 3000 $quick
check "adaptive sigma" run 0 $sphere a.off --sigma auto $quick
check "error" run 0 $sphere e.off --error 2e-3 --no-distance
check "it is kept" grep -Eq '^error asked for: +0\.002 D, kept: the distance is 0\.00[0-9]+ D at most$' stdout
check "error and faces" run 0 $sphere ef.off --absolute-error 1e-5 --faces 500 --no-distance
check "the number of faces is reached first" grep -Eq '^error asked for: .*, not kept: the number of faces was reached before$' stdout
{
  echo "ply"
  echo "format ascii 1.0"
  echo "element vertex $(grep -c '^v ' sphere.obj)"
  printf 'property float %s\n' x y z heat
  echo "element face $(grep -c '^f ' sphere.obj)"
  echo "property list uchar int vertex_indices"
  echo "end_header"
  awk '$1 == "v" { print $2, $3, $4, ($4 > 0 ? $4 : -$4) }' sphere.obj
  awk '$1 == "f" { split($2, a, "/"); split($3, b, "/"); split($4, c, "/"); print 3, a[1] - 1, b[1] - 1, c[1] - 1 }' sphere.obj
} >heat.ply
check "field" run 0 heat.ply f.off --field heat --tau .2 $quick
check "it is named" grep -q 'field heat' stdout
refuses 1 "cold" heat.ply precious.off --field cold
refuses 1 "needs a PLY file" $sphere precious.off --field heat
refuses 2 "--tau needs --field" $sphere precious.off --tau 1
refuses 1 "from 1 to inf" $sphere precious.off --metric .5
refuses 1 "from 1 to inf" $sphere precious.off --metric nan
refuses 2 "--metric and --sigma cannot both be given" $sphere precious.off --metric 2 --sigma .1
refuses 2 "--metric and --length cannot both be given" $sphere precious.off --metric 2 --length 1
refuses 2 "--error and --length cannot both be given" $sphere precious.off --error .1 --length 1
refuses 2 "--field and --sigma auto cannot both be given" heat.ply precious.off --field heat --sigma auto
refuses 1 "above 0" $sphere precious.off --error 0
check "self-intersections" run 0 $sphere s.off --self-intersections $quick
check "their row" grep -Eq '^pairs of faces that intersect +0 +0$' stdout
check "no new self-intersections" run 0 $sphere n.off --avoid-self-intersections --self-intersections $quick
check "their row again" grep -Eq '^pairs of faces that intersect +0 +0$' stdout
check "no folded edges" grep -Eq '^folded edges +0 +0$' stdout
check "arrays in PLY" run 0 $sphere arrays.ply --arrays --faces 500 --sigma .02 $quick
check "of the vertices" grep -aq '^property double nx$' arrays.ply
check "of the faces" grep -aq '^property double smallest_angle_6d$' arrays.ply
check "it is read as any other" run 0 arrays.ply again.off $quick
check "arrays in VTP" run 0 $sphere arrays.vtp --arrays --faces 500 --sigma .02 --quiet $quick
# a number a line, as many as there are points or faces
numbers_in() { sed -n "/Name=\"$2\"/,/DataArray>/p" "$1" | grep -Ec '^[-+.0-9e]+( |$)'; }
check "all points" [ "$(numbers_in arrays.vtp points)" -eq "$(sed -n 's/.*NumberOfPoints="\([0-9]*\)".*/\1/p' arrays.vtp)" ]
for array in aspect_ratio smallest_angle_6d connectivity offsets; do
  check "all faces: $array" [ "$(numbers_in arrays.vtp $array)" -eq "$(sed -n 's/.*NumberOfPolys="\([0-9]*\)".*/\1/p' arrays.vtp)" ]
done
check "VTP without arrays" run 0 $sphere plain.vtp --faces 500 $quick
check "it has none" [ "$(grep -c aspect_ratio plain.vtp)" -eq 0 ]

# by measured error there is no function, and nothing is measured that needs one
check "measured error" run 0 $sphere me.vtp --faces 500 --iterations 2 --arrays --details --json me.json
check "it is named" grep -q '; by measured error, no embedding$' stdout
check "no function in the table" [ "$(grep -Ec '^function:|^projections:|zero set|6D|folded faces|smooth function' stdout)" -eq 0 ]
check "distances both ways" [ "$(grep -c '^distance \(to\|from\) the input, ' stdout)" -eq 4 ]
check "no function in the JSON" \
  [ "$(grep -Ec '"(function|kernel|sigma|distance_to_zero_set|least_distance_possible|smooth function)":|"embedding": {' me.json)" -eq 0 ]
check "all faces have an angle in space" [ "$(numbers_in me.vtp smallest_angle)" -eq 500 ]
distance_of_faces() { sed -n '/<CellData>/,/<\/CellData>/p' "$1" | sed -n '/Name="distance"/,/DataArray>/p' | grep '^[0-9]'; }
check "and a distance to the other mesh" [ "$(distance_of_faces me.vtp | awk '$1 > 1e-9 && $1 < .1' | wc -l)" -eq 500 ]
check "with a function there is all of it" run 0 $sphere mf.off --faces 500 --sigma .01 --json mf.json $quick
check "in the table" [ "$(grep -Ec '^function:|^projections:|zero set|folded faces|smooth function' stdout)" -eq 8 ]
check "and in the JSON" \
  [ "$(grep -Ec '"(function|kernel|sigma|distance_to_zero_set|least_distance_possible|smooth function)":' mf.json)" -gt 7 ]
# at most three quarters, as in the library
scheme_of() { "$program" "$1" s.off --quiet --iterations 0 --json - --faces "$2" | sed -n 's/.*"scheme": "\(.*\)".*/\1/p'; }
faces=$(grep -c '^f ' sphere.obj)
check "three quarters are by measured error" [ "$(scheme_of $sphere $((faces * 3 / 4)))" = measured-error ]
check "more are not" [ "$(scheme_of $sphere $((faces * 3 / 4 + 1)))" = embedding ]

refuses 1 "only written" arrays.vtp precious.off
refuses 2 "--arrays" $sphere precious.off --arrays
refuses 2 "--report" $sphere precious.off --report precious.off
refuses 2 "same file" $sphere out.off --report precious.json --json precious.json
refuses 1 "no_folder" $sphere precious.off --report no_folder/page.html
check "quiet" run 0 $sphere q.off --quiet $quick
check "quiet is silent" [ ! -s stdout -a ! -s stderr ]
check "one thread" run 0 $sphere threads_1.off --threads 1 $quick
check "two threads" run 0 $sphere threads_2.off --threads 2 $quick
check "the same result" cmp -s threads_1.off threads_2.off
check "distance" run 0 $sphere d.off --iterations 2 --details
check "distance both ways" [ "$(grep -c '^distance \(to\|from\) the input, ' stdout)" -eq 4 ]
check "no bar in a pipe" is_free_of_control_characters stderr
check "no control characters in the table" is_free_of_control_characters stdout
{ cat sphere.obj; echo "v 9 9 9"; } >isolated.obj
check "isolated vertex" run 0 isolated.obj isolated.off $quick
check "a note on it" says "1 vertices without a face"
mkdir target && ln -s target/real.off link.off
check "through a link" run 0 $sphere link.off $quick
check "the link stays, its target is written" [ -L link.off -a -s target/real.off ]
check "no temporary file beside it" has_no_temporary_file target

# ---------------------------------------------------------------------------------------------------------------- JSON
check "json" run 0 $sphere j.off --json j.json $quick
check "json on the standard output" run 0 $sphere j.off --json - $quick
cp stdout j2.json
check "a report" grep -q '"euler_characteristic": 2' j.json
check "no warnings" grep -q '"warnings": \[\]' j.json
# a needle without curvature, of which nothing can be made but thinner ones, and a curve that hardly any triangles follow
printf 'OFF\n3 1 0\n0 0 0\n1e-6 1 0\n0 1 0\n3 0 1 2\n' >needle.off
check "needles are no error" run 0 needle.off n.off --iterations 0 --json w.json
check "but a warning" says "hde_remesh: warning: 1 of 1 faces are needles"
check "in the JSON, too" grep -q '1 of 1 faces are needles' w.json
check "too few iterations for so many faces" run 0 $sphere w.off --faces 100000 --iterations 0 --json w.json --no-distance
check "which is said" says "hde_remesh: warning: there are "
check "and in the JSON" grep -q 'not about 100000' w.json
check "far from the input" run 0 $sphere w.off --faces 12 --json w.json
check "is said" says "D apart"
check "also in the JSON" grep -q 'D apart' w.json
check "not when it is quiet" run 0 $sphere w.off --faces 12 --quiet
check "which is silent" [ ! -s stderr ]
printf 'OFF\n8 12\n0 0 0\n0 0 1\n0 1 0\n0 1 1\n1 0 0\n1 0 1\n1 1 0\n1 1 1\n3 0 1 3\n3 0 3 2\n3 4 6 7\n3 4 7 5\n3 0 4 5\n3 0 5 1
3 2 3 7\n3 2 7 6\n3 0 2 6\n3 0 6 4\n3 1 5 7\n3 1 7 3\n' >cube.off
check "a cube without --sharp" run 0 cube.off w.off --faces 200 --smoothing auto --json w.json
check "has rounded edges" says "edges of IN that turn by 60 degrees or more are up to"
check "and nothing to smooth, as it has few points" says "--smoothing has no effect: 1 of 1 patches of the function are replaced by the distance to IN"
check "both in the JSON" [ "$(grep -Ec 'turn by 60 degrees|smoothing has no effect' w.json)" -eq 2 ]
check "a cube with --sharp" run 0 cube.off w.off --faces 200 --sharp 30
check "has none of it" [ ! -s stderr ]
check "an option of the function by measured error" run 0 $sphere w.off --faces 500 --scheme measured-error --kernel gaussian $quick
check "is told to have no effect" says "--kernel has no effect: by measured error there is no function"
check "a bound on aspect ratios by an embedding" run 0 $sphere w.off --faces 500 --sigma .1 --aspect-ratio 3 $quick
check "has no effect" says "--aspect-ratio has no effect by an embedding"
check "a bound on aspect ratios and a weight" run 0 $sphere w.off --faces 500 --aspect-ratio 3 --shape-weight 5 --json w.json $quick
check "are counted" grep -q "\"faces_beyond_aspect_ratio\":" w.json
printf 'OFF\n5 4\n0 0 0\n1 0 0\n.5 0 0\n.5 1 0\n.5 -1 0\n3 0 2 3\n3 2 1 3\n3 0 1 2\n3 1 0 4\n' >flat.off
check "a face without area" run 0 flat.off w.off --iterations 0 --json w.json
check "is flipped" says "note: 1 faces without area are contracted or flipped"
check "and counted" grep -q '"removed": 1' w.json
check "there is none in the table" grep -Eq '^degenerate faces +0 +0$' stdout
if command -v python3 >/dev/null; then
  check "valid json" python3 -m json.tool j.json /dev/null
  check "valid json on the standard output" python3 -m json.tool j2.json /dev/null
fi

# ----------------------------------------------------------------------------------------------------------- bad usage
refuses 2 "OUT is missing: hde_remesh IN OUT [OPTIONS]" $sphere
refuses 2 "IN and OUT are missing" --quiet
refuses 2 "'third.off' is one file too many" $sphere precious.off third.off
refuses 2 "unknown option --sgima: did you mean --sigma?" $sphere precious.off --sgima .1
refuses 2 "unknown option --sgima: did you mean --sigma?" --sgima=.1 $sphere precious.off
refuses 2 "unknown option --face: did you mean --faces?" $sphere precious.off --face 100
refuses 2 "unknown option -faces: did you mean --faces?" $sphere precious.off -faces 100
refuses 2 "unknown option --iter: did you mean --iterations?" $sphere precious.off --iter 3
refuses 2 "unknown option --repiar: did you mean --repair?" $sphere precious.off --repiar
refuses 2 "unknown option --nonsense: hde_remesh --help-all names all" $sphere precious.off --nonsense
refuses 2 "unknown option -x" $sphere precious.off -x
for option in --faces --vertices --iterations --relaxation-steps --patches --threads; do
  refuses 2 "$option needs a whole number, got many" $sphere precious.off $option many
  refuses 2 "$option needs a whole number, got 1e4" $sphere precious.off $option 1e4
  refuses 2 "$option needs a whole number" $sphere precious.off $option
done
for option in --length --error --absolute-error --aspect-ratio --shape-weight --absolute-sigma --tau --sharp --smoothing-ratio \
  --collapse-ratio --split-ratio --merge --trim --shape --overlap --offset; do
  refuses 2 "$option needs a number, got abc" $sphere precious.off $option abc
  refuses 2 "$option needs a number, got .1x" $sphere precious.off $option=.1x
  refuses 2 "$option needs a number" $sphere precious.off $option --quiet
done
for option in --sigma --smoothing; do
  refuses 2 "$option needs a number or auto, got abc" $sphere precious.off $option abc
  refuses 2 "$option needs a number or auto, got nothing" $sphere precious.off $option ""
done
refuses 2 "--metric needs a number or inf, got two" $sphere precious.off --metric two
refuses 2 "--kernel needs r3, thin-plate, gaussian, multiquadric, inverse-multiquadric, wendland-c2, wendland-c4 or wendland-c6, got cubic" \
  $sphere precious.off --kernel cubic
refuses 2 "--scheme needs default, measured-error, embedding or paper, got best" $sphere precious.off --scheme best
refuses 2 "--report needs the name of a file" $sphere precious.off --report
refuses 2 "--fit takes no value" $sphere precious.off --fit=yes
refuses 2 "--faces is given twice" $sphere precious.off --faces 100 --faces 200
refuses 2 "--shape and --kernel r3 cannot both be given" $sphere precious.off --shape 3
check "a value behind =" run 0 $sphere equals.off --faces=500 --iterations=1 --no-distance
check "is taken" grep -Eq '^faces +[0-9]+ +500$' stdout
refuses 1 "--sigma must be a finite number, 0 or more, not -inf" $sphere precious.off --sigma -inf
refuses 1 "shape" $sphere precious.off --kernel gaussian --shape -1
refuses 1 "smoothing" $sphere precious.off --smoothing -1
refuses 2 "--faces and --vertices cannot both be given" $sphere precious.off --faces 100 --vertices 100
refuses 2 "--faces and --length cannot both be given" $sphere precious.off --faces 100 --length 1
refuses 2 "--sigma and --absolute-sigma cannot both be given" $sphere precious.off --sigma .1 --absolute-sigma 1
refuses 2 "precious.off" $sphere precious.off --json precious.off
for option in --faces --vertices --patches --threads; do
  refuses 1 "$option must be 1 or more, not 0" $sphere precious.off $option 0
  refuses 1 "$option must be 1 or more, not -7" $sphere precious.off $option -7
done
for value in 0 -1 nan inf; do
  refuses 1 "$value" $sphere precious.off --length $value
  refuses 1 "$value" $sphere precious.off --offset $value
done
for value in -1 nan; do
  refuses 1 "$value" $sphere precious.off --sigma $value
  refuses 1 "$value" $sphere precious.off --absolute-sigma $value
done
for value in 0 180 -30 nan inf; do
  refuses 1 "--sharp must be above 0 and below 180 degrees, not $value" $sphere precious.off --sharp $value
done
refuses 1 "-1" $sphere precious.off --iterations -1
refuses 1 "--smoothing-ratio must be from 0 to 1, not 1.5" $sphere precious.off --smoothing-ratio 1.5
refuses 1 "--collapse-ratio must be from 0 to 1, not -1" $sphere precious.off --collapse-ratio -1
refuses 1 "--split-ratio must be from 1 to 100, not 0.5" $sphere precious.off --split-ratio .5
refuses 1 "--aspect-ratio must be 1.2 or more, not 1" $sphere precious.off --aspect-ratio 1
refuses 1 "-1" $sphere precious.off --shape-weight -1

# ------------------------------------------------------------------------------------------------------------- bad files
refuses 1 "cannot read 'missing.off': No such file" missing.off precious.off --json precious.json
refuses 1 "'.abc'" missing.abc precious.off
refuses 1 "only read, as they have no faces" $sphere out.xyz
refuses 1 "no extension" $sphere precious
refuses 1 "target" target precious.off
mkdir folder.off
refuses 1 "folder.off" $sphere folder.off
refuses 1 "cannot read 'folder.off': it is a directory" folder.off precious.off
refuses 1 "nowhere" $sphere nowhere/out.off
refuses 1 "nowhere" $sphere precious.off --json nowhere/out.json
if [ "$(id -u)" -ne 0 ]; then # root may write everything
  cp $sphere unreadable.off && chmod a-r unreadable.off
  refuses 1 "unreadable.off" unreadable.off precious.off
  mkdir locked && chmod a-w locked
  refuses 1 "locked" $sphere locked/out.off
fi

# --------------------------------------------------------------------------------------------------------- bad contents
: >empty.off
refuses 1 "cannot read 'empty.off': it is empty" empty.off precious.off --json precious.json
printf 'Dear reader,\nthis is no mesh.\n' >text
printf '\x89PNG\r\n\x1a\n\0\0\0\rIHDR' >picture
for format in obj ply stl xyz; do
  : >empty.$format
  refuses 1 "cannot read 'empty.$format': it is empty" empty.$format precious.off
done
for format in off obj ply stl xyz; do
  cp text text.$format
  refuses 1 "cannot read 'text.$format': it is no ${format^^} file: " text.$format precious.off
  cp picture picture.$format
  refuses 1 "cannot read 'picture.$format': it is a PNG picture, and no ${format^^} file" picture.$format precious.off
done
printf ' \n\n' >blanks.obj
refuses 1 "it has nothing but blanks" blanks.obj precious.off
printf 'version https://git-lfs.github.com/spec/v1\n' >pointer.ply
refuses 1 "it is a pointer of Git LFS" pointer.ply precious.off
for format in obj ply stl; do
  cp sphere.$format wrong_$format.off
  refuses 1 "${format^^} file: then its name must end in .$format" wrong_$format.off precious.off
done
cp sphere.off wrong_off.ply
refuses 1 "it looks like an OFF file: then its name must end in .off" wrong_off.ply precious.off
printf 'OFF\n0 0 0\n' >no_faces.off
refuses 1 "no faces" no_faces.off precious.off
printf 'OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n' >points_only.off
refuses 1 "3 points and no faces: too few" points_only.off precious.off
printf 'OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n' >nan.off
refuses 1 "'nan'" nan.off precious.off
printf 'OFF\n3 1 0\n0 0 0\n1 0 inf\n0 1 0\n3 0 1 2\n' >inf.off
refuses 1 "'inf'" inf.off precious.off
printf 'OFF\n3 1 0\n0 0 0\n1 0 1e999\n0 1 0\n3 0 1 2\n' >large.off
refuses 1 "1e999" large.off precious.off
printf 'OFF\n3 1 0\n0 0 0\n1 0 1e300\n0 1 0\n3 0 1 2\n' >overflow.off
refuses 1 "overflow.off" overflow.off precious.off
printf 'v 0 0 0\nv 1 X 0\nv 0 1 0\nf 1 2 3\n' >word.obj
refuses 1 "line 2" word.obj precious.off
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n' >index.obj
refuses 1 "face 1 of 1" index.obj precious.off
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -9\n' >negative.obj
refuses 1 "line 4: expected a vertex of face 1 among the 3 before it, found '-9'" negative.obj precious.off
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n' >zero.obj
refuses 1 "line 4" zero.obj precious.off
printf 'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 nan 0\n3 0 1 2\n' >nan.ply
refuses 1 "line 12" nan.ply precious.off
printf 'solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 nan 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid s\n' >nan.stl
refuses 1 "line 5" nan.stl precious.off
# one facet, its first coordinate a binary nan
{ head -c 80 /dev/zero; printf '\x01\x00\x00\x00'; head -c 12 /dev/zero; printf '\x00\x00\xc0\x7f'; head -c 34 /dev/zero; } \
  >binary_nan.stl
refuses 1 "face 1" binary_nan.stl precious.off
# headers of PLY that CGAL's reader would trust
refuses_ply() {
  local text=$1
  shift
  printf '%s\n' "$@" >header.ply
  refuses 1 "$text" header.ply precious.off
}
refuses_ply "line 1" "element vertex 3"
refuses_ply "line 3: a property comes before any element" ply "format ascii 1.0" "property float x" "element vertex 1" end_header
refuses_ply "line 3: the file is too short for 99999999999 of vertex" ply "format ascii 1.0" "element vertex 99999999999" end_header
refuses_ply "no property of a known type" ply "format ascii 1.0" "element vertex 1" "property long x" end_header
refuses_ply "'vertex' begins no line" ply "vertex 1" end_header
refuses_ply "the header does not end" ply "format ascii 1.0" "element vertex 1"

for format in off obj ply stl; do
  head -c $(($(stat -c %s sphere.$format) * 2 / 3)) sphere.$format | head -c -3 >truncated.$format
  [ $format = obj ] && continue # any number of whole lines is a file of this format
  refuses 1 "cannot read 'truncated.$format': it is cut off: " truncated.$format precious.off
done
head -c 3000 /dev/urandom >noise
for format in off obj ply stl; do
  cp noise noise.$format
  refuses 1 "noise.$format" noise.$format precious.off
done
printf 'OFF\n99999999999 99999999999 0\n0 0 0\n' >huge.off
refuses 1 "huge.off" huge.off precious.off

# ------------------------------------------------------------------------------------------- not a manifold triangle mesh
refuses 1 "has 4 vertices" "$data/quad.off" precious.off
printf 'OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n' >square.off
refuses 1 "face 1 of 1 has 4 vertices" square.off precious.off
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 1\n' >twice.off
refuses 1 "twice" twice.off precious.off
printf 'OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 -1 0\n0 0 1\n3 0 1 2\n3 1 0 3\n3 0 1 4\n' >edge.off
refuses 1 "has 3 faces" edge.off precious.off
printf 'OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 1 2 3\n' >flipped.off
refuses 1 "oriented" flipped.off precious.off
printf 'OFF\n5 2 0\n0 0 0\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n3 0 1 2\n3 0 3 4\n' >bow_tie.off
refuses 1 "touch in a point" bow_tie.off precious.off
refuses 1 "touch in a point" "$data/pig.stl" precious.off
printf 'OFF\n3 1 0\n1 1 1\n1 1 1\n1 1 1\n3 0 1 2\n' >point.off
refuses 1 "point.off" point.off precious.off

# -------------------------------------------------------------------------------------------------------------- repair
for name in square twice edge flipped bow_tie; do
  refuses 1 "--repair may mend it" $name.off precious.off
done
# repairs NAME NOTE OPTIONS...: of NAME.off, which the note tells
repairs() {
  local name=$1 text=$2
  shift 2
  check "repair $name" run 0 $name.off repaired.off --repair --iterations 0 --no-distance "$@"
  check "it says: $text" says "$text"
  check "no fold after it" grep -Eq '^folded faces +[0-9]+ +0$' stdout
}
repairs square "1 faces divided into triangles"
repairs flipped "1 faces turned over"
repairs bow_tie "1 points doubled where sheets touch"
repairs edge "points doubled where sheets touch"
repairs sphere "nothing to repair"
check "repair of the touching sheets of the data" run 0 "$data/pig.stl" repaired.off --repair $quick
# a sphere as a soup of single triangles, one of them twice, half of them turned
awk '$1 == "v" { x[++n] = $2 " " $3 " " $4 }
     $1 == "f" { split($2, a, "/"); split($3, b, "/"); split($4, c, "/"); t[++m] = a[1] " " b[1] " " c[1] }
     END { print "OFF"; print 3 * m + 3, m + 1, 0
           for (i = 1; i <= m + 1; ++i) { split(t[i > m ? 1 : i], v, " "); print x[v[1]]; print x[v[2]]; print x[v[3]] }
           for (i = 0; i <= m; ++i) print 3, (i % 2 ? 3 * i " " 3 * i + 1 : 3 * i + 1 " " 3 * i), 3 * i + 2 }' \
  sphere.obj >soup.off
check "the soup without repair is one triangle after the other" [ "$("$program" soup.off o.off $quick | awk '/^components/ { print $2 }')" -gt 900 ]
repairs soup "equal points merged" --json repair.json
check "the soup is a sphere" grep -Eq '^Euler characteristic +2 +2$' stdout
check "a double face" grep -q '"removed_faces": 1,' repair.json
refuses 1 "line 5" nan.stl precious.off --repair
refuses 1 "face 1 of 1" index.obj precious.off --repair
refuses 2 "--field and --repair cannot both be given" heat.ply precious.off --repair --field heat
refuses 2 "--field and --merge cannot both be given" heat.ply precious.off --merge .1 --field heat

# -------------------------------------------------------------------------------------------------------------- cracks
# torn FORMAT SIZE: sphere.obj as single triangles, whose points are up to SIZE / 2 from where they were, in text STL or OFF
torn() {
  awk -v format="$1" -v size="$2" 'BEGIN { srand(1) }
    function number(x) { return sprintf("%.9g", x + size * (rand() - .5) / 2) }
    $1 == "v" { ++n; x[n] = $2; y[n] = $3; z[n] = $4 }
    $1 == "f" { ++m; for (k = 2; k <= 4; ++k) { split($k, a, "/"); p[++c] = number(x[a[1]]) " " number(y[a[1]]) " " number(z[a[1]]) } }
    END { if (format == "off") print "OFF\n" c, m; else print "solid s"
          for (i = 1; i <= c; ++i)
            if (format == "off") print p[i]
            else { if (i % 3 == 1) print "facet normal 0 0 1\nouter loop"; print "vertex " p[i]; if (i % 3 == 0) print "endloop\nendfacet" }
          if (format == "off") for (i = 0; i < m; ++i) print 3, 3 * i, 3 * i + 1, 3 * i + 2
          else print "endsolid s" }' sphere.obj
}
is_closed_sphere() { grep -Eq '^components +1 +1$' stdout && grep -Eq '^Euler characteristic +2 +2$' stdout; }
nothing="--iterations 0 --no-distance"
torn stl 1e-7 >rounded.stl
check "STL with cracks of rounding" run 0 rounded.stl o.off $nothing --json cracks.json
check "it is closed" is_closed_sphere
check "its points are joined, which is said" grep -Eq 'note: [0-9]+ points are one with others within [0-9.e-]+, which closes cracks' stderr
check "and no more than that" [ "$(wc -l <stderr)" -eq 1 ]
check "in the JSON with the tolerance" grep -Eq '"tolerance": [0-9.]+e-07,' cracks.json
torn off 1e-7 >rounded.off
check "OFF stays as it is" run 0 rounded.off o.off $nothing
check "a thousand components" grep -Eq '^components +(9[0-9]{2}|1[0-9]{3}) ' stdout
check "with advice" grep -Eq 'warning: IN is open only by cracks of up to [1-9](\.[0-9])?e-08: --merge [1-9](\.[0-9])?e-08 closes them' stderr
length=$(sed -n 's/.*--merge \([^ ]*\) closes.*/\1/p' stderr)
check "which is right" run 0 rounded.off o.off $nothing --merge "$length"
check "then it is closed" is_closed_sphere
check "the advice is gone" [ "$(grep -c 'is open' stderr)" -eq 0 ]
torn off 4e-10 >digits.off
check "the repair of cracks in the last of nine digits" run 0 digits.off o.off $nothing --repair
check "closes the cracks, too" is_closed_sphere
# the same of floats, with all digits that tell them
awk 'BEGIN { srand(2) }
  $1 == "v" { ++n; for (k = 2; k <= 4; ++k) x[n, k] = 2^-24 * int(2^24 * $k) }
  $1 == "f" { ++m; for (k = 2; k <= 4; ++k) { split($k, a, "/"); ++c; for (i = 2; i <= 4; ++i) p[c, i] = x[a[1], i] + (rand() < .2 ? 2^-24 : 0) } }
  END { print "OFF\n" c, m; for (i = 1; i <= c; ++i) printf "%.17g %.17g %.17g\n", p[i, 2], p[i, 3], p[i, 4]
        for (i = 0; i < m; ++i) print 3, 3 * i, 3 * i + 1, 3 * i + 2 }' sphere.obj >floats.off
check "the repair of cracks in the last place of floats, written as doubles" run 0 floats.off o.off $nothing --repair
check "closes these, too" is_closed_sphere
torn stl 1e-4 >wide.stl
check "STL with wider cracks" run 0 wide.stl o.off $nothing
check "no advice for cracks as wide" [ "$(grep -c 'is open only' stderr)" -eq 0 ]
check "a length for it" run 0 wide.stl o.off $nothing --merge 1e-4
check "it is closed as well" is_closed_sphere
awk 'BEGIN { for (i = 0; i < 2; ++i) for (j = 0; j < 2; ++j) print "v", 5e5 + i, 5e5 + j, 0; print "f 1 3 4\nf 1 4 2" }' >near.obj
check "far from the origin as STL" run 0 near.obj far.stl --iterations 0 --no-distance
check "less than its rounding asked for" run 0 far.stl o.off --absolute-error .001
check "which is said" says "the coordinates of IN are rounded to 0.031, which is more than the error asked for"
check "not where it is more" run 0 far.stl o.off --absolute-error .1
check "then nothing is said of it" [ "$(grep -c 'are rounded to' stderr)" -eq 0 ]
refuses 1 "--merge must be a finite number above 0, not 0" $sphere precious.off --merge 0
torn off 0 >single.off
check "points that coincide" run 0 single.off o.off $nothing
check "are said" says "IN is open only where points coincide: --repair joins them"
sed '$d' single.off | awk 'NR == 2 { --$2 } { print }' >hole.off
check "with a hole" run 0 hole.off o.off $nothing
check "the single triangles are said" grep -Eq 'warning: [0-9]+ triangles of IN have no neighbour' stderr
check "a whole mesh needs no advice" run 0 $sphere o.off $nothing
check "and gets none" [ ! -s stderr ]
printf 'OFF\n5 3\n0 0 0\n1 0 0\n.25 .25 0\n0 1 0\n0 0 5\n4 0 1 2 3\n3 0 2 1\n3 2 0 3\n' >arrow.off
check "a quadrangle with an edge for a diagonal" run 0 arrow.off o.off $nothing --repair
check "gets another point" says "1 points added on diagonals"
sed '$d' rounded.stl >cut.stl
check "STL without endsolid" run 0 cut.stl o.off $nothing
check "may have been cut off" says "note: the file has no endsolid"

# -------------------------------------------------------------------------------------------- a full disk, and signals
echo precious >old.off
(ulimit -f 8; exec "$program" "$data/sphere.off" old.off --faces 5000 $quick >stdout 2>stderr)
check "a file that may not grow is an error" [ $? -eq 1 ]
check "one line on it" says "cannot write 'old.off'"
check "the old file is untouched" grep -qx precious old.off
check "no temporary file" has_no_temporary_file
if [ -w /dev/full ]; then
  "$program" $sphere full.off $quick >/dev/full 2>stderr
  check "a full standard output is an error" [ $? -eq 1 ]
  check "one line on that" says "standard output"
fi

# interrupt SIGNAL STATUS TEXT: during the computation
interrupt() {
  # in a shell of its own with job control: a background process of this one would ignore Ctrl-C
  bash -c 'set -m; "$1" "$2" old.off --faces 60000 --iterations 100000 >stdout 2>stderr & sleep 2; kill -'"$1"' $!; wait $!' \
    - "$program" "$data/bunny00.off" 2>/dev/null
  check "status after SIG$1" [ $? -eq "$2" ]
  check "a line on SIG$1" grep -qx "hde_remesh: $3; nothing was written" stderr
  check "the old file after SIG$1" grep -qx precious old.off
  check "no temporary file after SIG$1" has_no_temporary_file
}
interrupt INT 130 cancelled
interrupt TERM 143 "stopped by a signal"
bash -c 'set -m; "$1" "$2" old.off --faces 60000 --iterations 100000 >stdout 2>stderr & sleep 2; kill -KILL $!; wait $!' \
  - "$program" "$data/bunny00.off" 2>/dev/null
check "status after SIGKILL" [ $? -eq 137 ]
check "the old file after SIGKILL" grep -qx precious old.off
rm -f .hde_remesh*

summary
