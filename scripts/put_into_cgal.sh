#!/usr/bin/env bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Puts the package into a tree of CGAL, in the place and the form of CGAL's own packages: the headers, the examples, the tests of the
# headers, the manual for CGAL's Doxygen style and the package's description. What the tree has of the package already is replaced.
# Usage: scripts/put_into_cgal.sh TREE
# TREE is a clone of CGAL, with a folder for each package, or a release, with the headers of all packages in include/CGAL.

set -euo pipefail
if [[ $# -ne 1 || ! -d $1 ]]; then
  echo "usage: $0 TREE_OF_CGAL" >&2
  exit 2
fi
tree=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")/.."
package=Anisotropic_hde_remeshing

if [[ -e $tree/Installation/include/CGAL/version.h ]]; then
  place=$tree/$package
  is_clone=true
elif [[ -e $tree/include/CGAL/version.h ]]; then
  place=$tree
  is_clone=false
else
  echo "$tree is no tree of CGAL: it has neither Installation/include/CGAL/version.h nor include/CGAL/version.h" >&2
  exit 1
fi

# copy FROM FOLDER: the folder, as it is, without what lies there
copy() {
  rm -rf "${place:?}/$2"
  mkdir -p "$(dirname "$place/$2")"
  cp -R "$1" "$place/$2"
}

# add_line FILE LINE BEFORE: once, behind the line that begins so, or at the end
add_line() {
  if grep -qxF -- "$2" "$1"; then
    return
  fi
  line=$2 before=$3 awk '{ print } index($0, ENVIRON["before"]) == 1 && !is_there { print ENVIRON["line"]; is_there = 1 }
    END { if (!is_there) print ENVIRON["line"] }' "$1" > "$1.new"
  mv "$1.new" "$1"
}

# the headers; in a clone, those of the licenses lie together
mkdir -p "$place/include/CGAL"
rm -rf "$place/include/CGAL/$package"
cp -R include/CGAL/* "$place/include/CGAL/"
if $is_clone; then
  license=$tree/Installation/include/CGAL/license
  rm -rf "$place/include/CGAL/license"
  cp "include/CGAL/license/$package.h" "$license/"
  [[ ! -e $license/gpl_package_list.txt ]] ||
    add_line "$license/gpl_package_list.txt" "$package Anisotropic Surface Remeshing" "Alpha_wrap_3 "
fi

copy "examples/$package" "examples/$package"
rm -rf "$place/examples/$package/hde_remesh" "$place/examples/$package/hde_remesh_mpi"
cp cmake/cgal_tree/examples.cmake "$place/examples/$package/CMakeLists.txt"
cp cmake/cgal_tree/common.cmake "$place/examples/$package/"

# the tests that need no parts of the program hde_remesh
rm -rf "$place/test/$package"
mkdir -p "$place/test/$package"
cp "test/$package"/*.h "test/$package"/test_*.cpp "$place/test/$package/"
grep -lF '/hde_remesh/' "$place/test/$package"/*.cpp | xargs rm -f
cp cmake/cgal_tree/tests.cmake "$place/test/$package/CMakeLists.txt"
cp cmake/cgal_tree/common.cmake "$place/test/$package/"

copy "doc/$package" "doc/$package"
(cd "$place/doc/$package" && rm -rf CMakeLists.txt concept_pages.cmake layout.xml manual.css pictures Named_parameters.txt)
cp cmake/cgal_tree/Doxyfile.in "$place/doc/$package/"
sed -i '/hde_remesh\//d' "$place/doc/$package/examples.txt"
if ! $is_clone; then # of which headers a release makes the manual
  find include/CGAL -name '*.h' ! -path '*/internal/*' ! -path '*/license/*' -printf 'CGAL/%P\n' | sort > "$place/doc/$package/filelist.txt"
fi
list=$tree/Documentation/doc/Documentation/packages.txt # in a clone
if [[ -e $list ]]; then
  add_line "$list" "\\package_listing{$package}" '\package_listing{Polygon_mesh_processing}'
fi
copy "package_info/$package" "package_info/$package"

echo "$package is in $place"
