#!/usr/bin/env bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Makes the pictures of the README and the manual from the package's own runs: installs what is missing (packages of Debian),
# builds hde_remesh and draw_function, remeshes, and renders off screen, the same part with the same camera.
# Usage: scripts/make_pictures.sh [LUCY VESSEL [CRANK]]
# Those of Lucy, of a vessel and of a crank are made if their meshes are given: the Stanford statue, any vessel, standing
# upright in y, and a machine part with sharp edges.
# BUILD_DIR (default build/hde_remesh) and JOBS (default 2) may be set in the environment.

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
absolute_paths "$@"
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build_dir=${BUILD_DIR:-build/hde_remesh}
picture_dir=$(realpath -m doc/Anisotropic_hde_remeshing/fig)

# to_obj IN OUT.obj: the mesh as it is; f3d does not read OFF
to_obj() {
  if [[ $1 == *.off ]]; then
    awk '
      { sub(/#.*/, "") }
      NF == 0 || $1 == "OFF" { next }
      !has_counts { number_of_vertices = $1; has_counts = 1; next }
      read < number_of_vertices { print "v", $1, $2, $3; ++read; next }
      { print "f", $2 + 1, $3 + 1, $4 + 1 }' "$1" > "$2"
  else
    "$program" "$1" "$2" --iterations 0 --quiet --no-distance
  fi
}

# camera MESH.obj DIRECTION FOCUS WIDTH: the options of f3d for a view of the part of the mesh that is FOCUS=X,Y,Z off the middle of
# its bounding box, WIDTH high, seen from DIRECTION=X,Y,Z; all but the direction are fractions of the diagonal
camera() {
  awk -v direction="$2" -v focus="$3" -v width="$4" '
    /^v / { for (i = 2; i <= 4; ++i) {
        if (!count || $i < low[i]) low[i] = $i
        if (!count || $i > high[i]) high[i] = $i
      }
      ++count
    }
    END {
      split(direction, d, ","); split(focus, f, ",")
      for (i = 2; i <= 4; ++i) diagonal += (high[i] - low[i]) ^ 2
      diagonal = sqrt(diagonal)
      for (i = 1; i <= 3; ++i) length_of_d += d[i] ^ 2
      distance = diagonal * width / (2 * sin(10 * 3.14159265 / 180) / cos(10 * 3.14159265 / 180))
      for (i = 1; i <= 3; ++i) {
        focal[i] = (low[i + 1] + high[i + 1]) / 2 + f[i] * diagonal
        position[i] = focal[i] + distance * d[i] / sqrt(length_of_d)
      }
      printf "--camera-view-angle 20 --camera-focal-point %.9g,%.9g,%.9g --camera-position %.9g,%.9g,%.9g", focal[1], focal[2], focal[3],
        position[1], position[2], position[3]
    }' "$1"
}

# render MESH PICTURE SIZE CAMERA [OPTION...]: twice the size that is wanted, as f3d does not smooth lines
render() {
  local view
  read -r -a view <<< "$4"
  xvfb-run -a f3d --dry-run --quiet --line-width 2 --color .95,.9,.8 --no-background --resolution "$3" --camera-view-up 0,1,0 \
    "${view[@]}" "${@:5}" --output "$2" "$1"
}

# with_colors: the options for the colours of draw_function
with_colors=(--scalars=RGBA --comp=-2 --roughness 1)

# finish PICTURE OPTION...: of the parts, halved, in few colours, which keep the file small
finish() {
  convert "${@:2}" +repage -background white -alpha remove -resize 50% -strip "$picture_dir/$1"
  echo "$picture_dir/$1"
}
gray=(-colorspace Gray -colors 32)

# what has too many triangles for a picture is shaded
bunny_and_knot() {
  to_obj "$bunny" before.obj
  to_obj "$knot" knot-before.obj
  "$program" "$bunny" after.obj --faces 4000 --sigma .1 --quiet --no-distance
  "$program" "$knot" knot-after.obj --faces 2000 --sigma .2 --quiet --no-distance
  render before.obj before.png 1400,1160 "$(camera before.obj 0,0,1 0,0,0 .74)"
  render after.obj after.png 1400,1160 "$(camera before.obj 0,0,1 0,0,0 .74)" --edges
  for mesh in knot-before knot-after; do
    render $mesh.obj $mesh.png 1400,1200 "$(camera knot-before.obj 0,0,1 0,0,0 .74)" --edges
  done
  finish before_after.png \( before.png after.png +append \) \( knot-before.png knot-after.png +append \) -append "${gray[@]}"
}

lucy_at_three_levels() {
  to_obj "$1" lucy.obj
  local faces
  for faces in 20000 5000; do
    "$program" "$1" "lucy-$faces.obj" --faces $faces --quiet --no-distance
  done
  for mesh in lucy lucy-20000 lucy-5000; do
    render $mesh.obj $mesh-whole.png 960,1500 "$(camera lucy.obj 0,.15,1 0,0,0 .9)"
    render $mesh.obj $mesh-bust.png 960,960 "$(camera lucy.obj 0,.15,1 .03,.24,0 .13)" --edges
  done
  finish lucy.png \( lucy-whole.png lucy-20000-whole.png lucy-5000-whole.png +append \) \
    \( lucy-bust.png lucy-20000-bust.png lucy-5000-bust.png +append \) -append "${gray[@]}"
}

# the metric of the curvature beside equal triangles, on a part that is flat here and curved there
metric_of_the_curvature() {
  local name
  "$program" "$fandisk" metric-none.obj --faces 2000 --sharp 20 --sigma 0 --quiet --no-distance
  "$program" "$fandisk" metric-2.obj --faces 2000 --sharp 20 --metric 2 --quiet --no-distance
  for name in metric-none metric-2; do
    render $name.obj $name.png 1400,1100 "$(camera metric-2.obj 1,.6,1.4 0,0,0 .75)" --edges
  done
  finish metric.png metric-none.png metric-2.png +append "${gray[@]}"
}

errors_asked_for() {
  local error parts=()
  for error in .01 .003 .001; do
    "$program" "$bunny" "error-$error.obj" --error $error --quiet --no-distance
    render "error-$error.obj" "error-$error.png" 960,800 "$(camera before.obj 0,0,1 0,0,0 .74)" --edges
    parts+=("error-$error.png")
    echo "error $error: $(grep -c '^f ' "error-$error.obj") triangles"
  done
  finish error.png "${parts[@]}" +append "${gray[@]}"
}

# noise of 0.002 D in each coordinate, of equal probability, and the surface through it
noise_removed() {
  awk 'BEGIN { srand(1) } $1 == "v" { for (i = 2; i <= 4; ++i) $i += .002 * 1.60244 * 2 * (rand() - .5) } { print }' before.obj > noisy.obj
  "$program" noisy.obj noise-kept.obj --faces 20000 --sigma .02 --quiet --no-distance
  "$program" noisy.obj noise-removed.obj --faces 20000 --sigma .02 --smoothing auto --quiet --no-distance
  for mesh in noisy noise-kept noise-removed; do
    render $mesh.obj $mesh.png 960,800 "$(camera before.obj 0,0,1 0,0,0 .74)"
  done
  finish noise.png noisy.png noise-kept.png noise-removed.png +append "${gray[@]}"
}

# waves across the bunny, dark and light, a property of its vertices, which the triangles resolve
field_resolved() {
  awk '{ sub(/\r$/, "") } $1 == "v" { w = sin(15 * ($2 + $3)); g = int(135 + 110 * w)
      v[++n] = $2 " " $3 " " $4 " " w " " g " " g " " g " 255" }
    $1 == "f" { f[++m] = 3 " " $2 - 1 " " $3 - 1 " " $4 - 1 }
    END { print "ply\nformat ascii 1.0\nelement vertex " n
          print "property double x\nproperty double y\nproperty double z\nproperty double wave"
          print "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\nelement face " m
          print "property list uchar int vertex_indices\nend_header"
          for (i = 1; i <= n; ++i) print v[i]; for (i = 1; i <= m; ++i) print f[i] }' before.obj > wave.ply
  "$program" wave.ply field-none.obj --faces 5000 --sigma .01 --quiet --no-distance
  "$program" wave.ply field-wave.obj --faces 5000 --sigma .01 --field wave --tau .2 --quiet --no-distance
  render wave.ply wave.png 960,800 "$(camera before.obj 0,0,1 0,0,0 .74)" "${with_colors[@]}"
  for mesh in field-none field-wave; do
    render $mesh.obj $mesh.png 960,800 "$(camera before.obj 0,0,1 0,0,0 .74)" --edges
  done
  finish field.png \( wave.png -gamma 1.7 \) field-none.png field-wave.png +append "${gray[@]}"
}

vessel_at_three_levels() {
  to_obj "$1" vessel.obj
  local faces
  for faces in 3000 12932 40000; do
    "$program" "$1" "vessel-$faces.obj" --faces $faces --sigma .05 --quiet
  done
  for mesh in vessel vessel-3000 vessel-12932 vessel-40000; do
    render $mesh.obj $mesh.png 700,1400 "$(camera vessel.obj 0,0,1 0,0,0 .95)"
    render $mesh.obj $mesh-detail.png 700,700 "$(camera vessel.obj 0,0,1 0,-.1,0 .25)" --edges
  done
  finish vessel.png \( vessel.png vessel-3000.png vessel-12932.png vessel-40000.png +append \) \
    \( vessel-detail.png vessel-3000-detail.png vessel-12932-detail.png vessel-40000-detail.png +append \) -append "${gray[@]}"
}

# rounded_and_sharp MESH NAME DEGREES DIRECTION FOCUS OPTION...: NAME.png, the mesh remeshed without --sharp and with it, seen from
# DIRECTION, and its part at FOCUS
rounded_and_sharp() {
  local name=$2 direction=$4 focus=$5 mesh
  "$program" "$1" "$name-rounded.obj" "${@:6}" --quiet --no-distance
  "$program" "$1" "$name-sharp.obj" "${@:6}" --quiet --no-distance --sharp "$3"
  for mesh in "$name-rounded" "$name-sharp"; do
    render "$mesh.obj" "$mesh.png" 1400,1100 "$(camera "$name-sharp.obj" "$direction" 0,0,0 .75)" --edges
    render "$mesh.obj" "$mesh-detail.png" 1400,900 "$(camera "$name-sharp.obj" "$direction" "$focus" .28)" --edges
  done
  finish "$name.png" \( "$name-rounded.png" "$name-sharp.png" +append \) \
    \( "$name-rounded-detail.png" "$name-sharp-detail.png" +append \) -append "${gray[@]}"
}

sigma_from_zero_to_large() {
  local sigma parts=()
  for sigma in 0 .05 .15 .5; do
    "$program" "$knot" knot.obj --faces 3000 --sigma $sigma --quiet --no-distance
    render knot.obj "knot-$sigma.png" 960,960 "$(camera knot.obj 0,0,1 0,0,0 .8)" --edges
    parts+=("knot-$sigma.png")
  done
  finish sigma.png "${parts[@]}" +append "${gray[@]}"
}

# uniform in the embedding, contracted only, the default, and the least distance
measured_error() {
  local lion=$data/lion-head.off name whole=(lion-whole.png) detail=(lion-detail.png)
  to_obj "$lion" lion.obj
  "$program" "$lion" lion-embedding.obj --vertices 1000 --sigma .02 --quiet
  "$program" "$lion" lion-contracted.obj --vertices 1000 --iterations 0 --quiet
  "$program" "$lion" lion-default.obj --vertices 1000 --quiet
  "$program" "$lion" lion-least.obj --vertices 1000 --scheme measured-error --fit --quiet
  for name in embedding contracted default least; do
    whole+=("lion-$name-whole.png")
    detail+=("lion-$name-detail.png")
  done
  for name in lion lion-embedding lion-contracted lion-default lion-least; do
    render $name.obj $name-whole.png 760,760 "$(camera lion.obj .7,.4,1 0,0,0 .8)" --edges
    render $name.obj $name-detail.png 760,760 "$(camera lion.obj .7,.4,1 .02,0,.1 .3)" --edges
  done
  finish measured_error.png \( "${whole[@]}" +append \) \( "${detail[@]}" +append \) -append "${gray[@]}"
}

patches_of_the_function() {
  local k parts=()
  for k in 40 400 default; do
    # 25 points a patch, as the default is
    "$draw" patches "$bunny" patches.ply "${k/default/$(($(wc -l < before.obj) / 75))}"
    render patches.ply "patches-$k.png" 1200,1100 "$(camera before.obj 0,0,1 0,0,0 .74)" "${with_colors[@]}"
    parts+=("patches-$k.png")
  done
  finish patches.png "${parts[@]}" +append -gamma 1.7 -modulate 100,170 -colors 128
}

curvature_directions() {
  "$program" "$knot" knot.obj --faces 1500 --sigma .3 --quiet --no-distance
  "$draw" directions "$knot" knot.obj directions.ply
  render directions.ply directions.png 1400,1200 "$(camera knot.obj 0,0,1 0,0,0 .75)" "${with_colors[@]}" --edges
  render directions.ply directions-detail.png 1400,1200 "$(camera knot.obj 0,0,1 .2,.16,0 .3)" "${with_colors[@]}" --edges
  finish directions.png directions.png directions-detail.png +append -gamma 1.7 -modulate 100,140 -colors 64
}

report_page() {
  cp "$bunny" bunny00.off # the page names it
  "$program" bunny00.off bunny.obj --faces 12000 --sigma .03 --quiet --report report.html
  chromium --headless --no-sandbox --hide-scrollbars --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader \
    --virtual-time-budget=20000 --window-size=1200,1180 --screenshot=report.png "file://$PWD/report.html" > chromium.log 2>&1
  convert report.png -bordercolor white -trim -border 20 +repage -strip -colors 128 "$picture_dir/report.png"
  echo "$picture_dir/report.png"
}

install_packages
install_missing f3d xvfb xauth imagemagick chromium
unpack_cgal_data "$build_dir"
cmake -Wno-dev -S . -B "$build_dir" -DCMAKE_BUILD_TYPE=Release -DCGAL_AHR_NATIVE=ON -DBUILD_TESTING=OFF
cmake --build "$build_dir" --target hde_remesh draw_function -j "${JOBS:-2}"
program=$(realpath "$(find "$build_dir" -name hde_remesh -type f -perm -u+x)")
draw=$(realpath "$(find "$build_dir" -name draw_function -type f -perm -u+x)")
data=$(realpath "$(cgal_data_dir "$build_dir")/meshes")
bunny=$data/bunny00.off
knot=$data/knot1.off
fandisk=$data/fandisk.off
mkdir -p "$picture_dir"

work_dir=$(mktemp -d)
trap 'rm -r "$work_dir"' EXIT
cd "$work_dir"
bunny_and_knot
metric_of_the_curvature
errors_asked_for
noise_removed
field_resolved
sigma_from_zero_to_large
measured_error
rounded_and_sharp "$fandisk" fandisk 20 1,.6,1.4 -.1,-.05,.1 --vertices 1500 --metric 2
patches_of_the_function
curvature_directions
report_page
if ((${#meshes[@]} > 0)); then
  lucy_at_three_levels "${meshes[0]}"
  vessel_at_three_levels "${meshes[1]}"
fi
if ((${#meshes[@]} > 2)); then
  rounded_and_sharp "${meshes[2]}" crank 30 -1,.6,.5 .1,.08,.25 --vertices 9000 --sigma .02 --scheme embedding
fi
