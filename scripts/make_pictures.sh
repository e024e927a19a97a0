#!/usr/bin/env bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Makes the picture of the README from the package's own run: installs what is missing (packages of Debian), builds
# hde_remesh, remeshes CGAL's bunny and renders both meshes off screen with the same cameras.
# Usage: scripts/make_pictures.sh
# BUILD_DIR (default build/hde_remesh) and JOBS (default 2) may be set in the environment.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh

build_dir=${BUILD_DIR:-build/hde_remesh}
picture_dir=doc/Anisotropic_hde_remeshing/fig

# to_obj FILE.off: the mesh as OBJ, as it is; f3d does not read OFF
to_obj() {
  awk '
    { sub(/#.*/, "") }
    NF == 0 || $1 == "OFF" { next }
    !has_counts { number_of_vertices = $1; has_counts = 1; next }
    read < number_of_vertices { print "v", $1, $2, $3; ++read; next }
    { print "f", $2 + 1, $3 + 1, $4 + 1 }' "$1"
}

# render MESH PICTURE SIZE CAMERA FOCAL_POINT ANGLE: the mesh with its edges, seen from CAMERA towards FOCAL_POINT with y
# upwards, the angle in degrees. Twice the size that is wanted, as f3d does not smooth lines.
render() {
  xvfb-run -a f3d --dry-run --quiet --edges --line-width 2 --color .95,.9,.8 --no-background --resolution "$3" \
    --camera-position "$4" --camera-focal-point "$5" --camera-view-up 0,1,0 --camera-view-angle "$6" \
    --output "$2" "$1"
}

install_packages
install_missing f3d xvfb xauth imagemagick
unpack_cgal_data "$build_dir"
cmake -Wno-dev -S . -B "$build_dir" -DCMAKE_BUILD_TYPE=Release -DCGAL_AHR_NATIVE=ON -DBUILD_TESTING=OFF
cmake --build "$build_dir" --target hde_remesh -j "${JOBS:-2}"
program=$(find "$build_dir" -name hde_remesh -type f -perm -u+x)

work_dir=$(mktemp -d)
trap 'rm -r "$work_dir"' EXIT
bunny=$(cgal_data_dir "$build_dir")/meshes/bunny00.off
to_obj "$bunny" > "$work_dir/before.obj"
"$program" "$bunny" "$work_dir/after.obj" --faces 12000 --sigma .03

for mesh in before after; do
  render "$work_dir/$mesh.obj" "$work_dir/$mesh-whole.png" 1400,1200 0,-0.01,3.1 0,-0.01,0 21
  render "$work_dir/$mesh.obj" "$work_dir/$mesh-ears.png" 1400,1000 2.2,2.2,1.2 -0.06,0.36,0 8
done
mkdir -p "$picture_dir"
convert \( "$work_dir/before-whole.png" "$work_dir/after-whole.png" +append \) \
  \( "$work_dir/before-ears.png" "$work_dir/after-ears.png" +append \) \
  -append +repage -background white -alpha remove -resize 50% -colorspace Gray -colors 32 -strip "$picture_dir/before_after.png"
echo "The picture: $picture_dir/before_after.png"
