#!/bin/bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# The archive of the sources that CPack makes has what a clone has, no more and no less, and can be configured.
#   test_archive.sh SOURCE_DIR BUILD_DIR CMAKE

if [ $# -ne 3 ] || [ ! -d "$1" ] || [ ! -f "$2/CPackSourceConfig.cmake" ] || [ ! -x "$3" ]; then
  echo "usage: $0 SOURCE_DIR BUILD_DIR CMAKE" >&2
  exit 2
fi
sources=$(realpath "$1")
config=$(realpath "$2")/CPackSourceConfig.cmake
cmake=$3
program=$cmake
# shellcheck source=program_checks.sh
source "$(dirname "$0")/program_checks.sh"

version=$(sed -n 's/^project(Anisotropic_hde_remeshing VERSION \([0-9.]*\) .*/\1/p' "$sources/CMakeLists.txt")
name=Anisotropic_hde_remeshing-$version
check "the archive is made" "$(dirname "$cmake")/cpack" --config "$config" -B "$folder/packages" >stdout 2>stderr
check "it has the name of the version" [ -s "packages/$name.tar.xz" ]
tar -xf "packages/$name.tar.xz"
check "all is in one folder" [ -f "$name/CMakeLists.txt" ]
if git -C "$sources" rev-parse >/dev/null 2>&1; then
  git -C "$sources" ls-files | grep -Ev '^\.(ci/|git)' | sort >expected
  (cd "$name" && find . ! -type d -printf '%P\n' | sort) >found
  check "the files are those of the clone" cmp expected found
fi
check "CHANGES begin with this version" grep -qx "## Release $version" <(sed -n '1,5p' "$name/CHANGES.md")
check "it can be configured" run 0 -S "$name" -B build -DBUILD_TESTING=OFF -DCGAL_AHR_WITH_EXAMPLES=OFF
check "and installed" run 0 --install build --prefix installed
check "the header is there" [ -f installed/include/CGAL/anisotropic_hde_remeshing.h ]

summary
