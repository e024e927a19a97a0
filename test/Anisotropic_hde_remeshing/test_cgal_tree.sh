#!/bin/bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# scripts/put_into_cgal.sh: where the package comes to lie in a clone and in a release of CGAL, and that CGAL's CMake finds its programs.
#   test_cgal_tree.sh SOURCE_DIR CMAKE [OPTIONS OF CMAKE...]

if [ $# -lt 2 ] || [ ! -x "$1/scripts/put_into_cgal.sh" ] || [ ! -x "$2" ]; then
  echo "usage: $0 SOURCE_DIR CMAKE [OPTIONS OF CMAKE...]" >&2
  exit 2
fi
sources=$(realpath "$1")
cmake=$2
shift 2
program=$sources/scripts/put_into_cgal.sh
package=Anisotropic_hde_remeshing
# shellcheck source=program_checks.sh
source "$(dirname "$0")/program_checks.sh"

files() { (cd "$1" && find . -type f -exec cksum {} + | sort -k 3); }

mkdir nothing
check "no tree" run 1 nothing
check "is told" says "is no tree of CGAL"
check "no argument" run 2

# a clone: a folder for each package, and lists of them
mkdir -p clone/Installation/include/CGAL/license clone/Documentation/doc/Documentation
touch clone/Installation/include/CGAL/version.h
printf 'Alpha_wrap_3 3D Alpha Wrapping\nMesh_2 Meshes\n' >clone/Installation/include/CGAL/license/gpl_package_list.txt
printf '\\package_listing{Polygon_mesh_processing}\n\\package_listing{Mesh_2}\n' >clone/Documentation/doc/Documentation/packages.txt
check "a clone" run 0 clone
place=clone/$package
for part in include/CGAL/anisotropic_hde_remeshing.h include/CGAL/$package/Measures.h doc/$package/Doxyfile.in \
  doc/$package/PackageDescription.txt doc/$package/Concepts doc/$package/fig doc/$package/dependencies examples/$package/CMakeLists.txt \
  examples/$package/remesh_example.cpp test/$package/CMakeLists.txt test/$package/test_embeddings.cpp test/$package/check.h \
  package_info/$package/license.txt; do
  check "$part" [ -e $place/$part ]
done
check "the license is with the others" [ -f clone/Installation/include/CGAL/license/$package.h -a ! -e $place/include/CGAL/license ]
check "it is in the list, in its place" [ "$(sed -n 2p clone/Installation/include/CGAL/license/gpl_package_list.txt)" = \
  "$package Anisotropic Surface Remeshing" ]
check "so is the manual" [ "$(sed -n 2p clone/Documentation/doc/Documentation/packages.txt)" = "\\package_listing{$package}" ]
check "the manual has CGAL's style" grep -qF '@INCLUDE = ${CGAL_DOC_PACKAGE_DEFAULTS}' $place/doc/$package/Doxyfile.in
check "nothing of hde_remesh, which needs other libraries" [ "$(grep -rl 'hde_remesh/' $place/test $place/examples $place/doc/*/examples.txt | wc -l)" -eq 0 ]
files clone >first
check "once more" run 0 clone
check "it is the same" diff first <(files clone)

# a release: the headers of all packages together
mkdir -p release/include/CGAL
touch release/include/CGAL/version.h
check "a release" run 0 release
check "the headers are among the others" [ -f release/include/CGAL/anisotropic_hde_remeshing.h -a -f release/include/CGAL/license/$package.h ]
check "the manual's headers are listed" grep -qx 'CGAL/anisotropic_hde_remeshing.h' release/doc/$package/filelist.txt
check "no internal ones" [ "$(grep -c internal release/doc/$package/filelist.txt)" -eq 0 ]

# CGAL's functions for tests take the programs
for part in test examples; do
  check "CMake takes the $part" "$cmake" -S release/$part/$package -B build_$part "$@" -DBUILD_TESTING=ON -DCGAL_ENABLE_TESTING=ON >stdout 2>stderr
  number=$(find release/$part/$package -name '*.cpp' | wc -l)
  targets=$("$cmake" --build build_$part --target help | grep -cE '^\.\.\. ([a-z0-9_]+_example|test_[a-z0-9_]+)$')
  check "all of the $part are there: $targets of $number" [ "$targets" -ge $((number - 1)) -a "$targets" -gt 10 ] # one is for CGAL 6.2
done

summary
