#!/usr/bin/env bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Builds all headers, examples and tests with other compilers, standards and versions of CGAL, with and without TBB, warnings
# being errors. Nothing is installed but compilers: CGAL, Boost and Eigen are unpacked from the packages of several suites of
# Debian, whose users have these versions together.
# Usage: scripts/build_elsewhere.sh [CONFIGURATION... | pairs | all]
# A configuration is COMPILER,STANDARD,SUITE,TBB, for example clang++,20,trixie,OFF. `pairs`, the default, are six of them, in which
# each compiler, standard, version of CGAL, and TBB or not, meets each of the others; `all` are 24.
# BUILD_DIR (default build/elsewhere), JOBS (default 2), TARGETS (default all public_headers; syntax_check compiles all programs,
# but makes none, which is much faster), SHARED (default OFF; ON: the programs share instantiations) and TESTS, a regular expression
# of the tests that are run (default none: without optimisation they are slow) may be set in the environment.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh

build_dir=${BUILD_DIR:-build/elsewhere}
read -r -a targets <<< "${TARGETS:-all public_headers}"
suites=(bookworm trixie forky) # CGAL 5.5.1, 6.0.1 and 6.2
pairs=(
  g++,17,bookworm,ON clang++,20,bookworm,OFF
  g++,20,trixie,OFF clang++,17,trixie,ON
  g++,17,forky,OFF clang++,20,forky,ON)

# all_configurations: one a line
all_configurations() {
  local suite compiler standard tbb
  for suite in "${suites[@]}"; do
    for compiler in g++ clang++; do
      for standard in 17 20; do
        for tbb in ON OFF; do
          echo "$compiler,$standard,$suite,$tbb"
        done
      done
    done
  done
}

# unpack_headers SUITE: those of CGAL, Boost and Eigen of another suite, by an apt of its own that leaves the system's alone; prints
# their folder
unpack_headers() {
  local suite=$1 folder uri options boost package
  folder=$(realpath "$build_dir")/headers-$suite
  if [[ ! -e $folder/complete ]]; then
    mkdir -p "$folder"/{lists/partial,cache/archives/partial}
    uri=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Component: main' 'Origin: Debian' \
      "Codename: $(. /etc/os-release && echo "$VERSION_CODENAME")" | head -n 1)
    echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $uri $suite main" > "$folder/sources.list"
    # what is installed must not count
    options=(-q -o "Dir::Etc::SourceList=$folder/sources.list" -o Dir::Etc::SourceParts=/dev/null -o Dir::State::Status=/dev/null
      -o "Dir::State::Lists=$folder/lists" -o "Dir::Cache=$folder/cache" -o APT::Sandbox::User="$(id -un)"
      -o Acquire::Languages=none)
    apt-get "${options[@]}" update >&2 || return
    boost=$(apt-cache "${options[@]}" depends libboost-dev | sed -n 's/^ *Depends: \(libboost.*-dev\)$/\1/p')
    (cd "$folder" && apt-get "${options[@]}" download libcgal-dev libeigen3-dev "$boost" >&2) || return
    for package in "$folder"/*.deb; do
      dpkg-deb --extract "$package" "$folder" || return
    done
    touch "$folder/complete"
  fi
  echo "$folder/usr"
}

# version_of HEADER MACRO: what it defines the macro as
version_of() {
  sed -n "s/^ *# *define $2 //p" "$1" | tail -n 1 | tr -d '"' | tr _ .
}

# build CONFIGURATION
build() {
  local compiler standard suite tbb folder status=0
  IFS=, read -r compiler standard suite tbb <<< "$1"
  folder=$(unpack_headers "$suite") || return
  unpack_cgal_data "$build_dir/$1"
  echo "Building $1 with CGAL $(version_of "$folder/include/CGAL/version.h" CGAL_VERSION)," \
    "Boost $(version_of "$folder/include/boost/version.hpp" BOOST_LIB_VERSION)"
  cmake -Wno-dev -S . -B "$build_dir/$1" -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_STANDARD="$standard" \
    -DCMAKE_PREFIX_PATH="$folder" -DCGAL_AHR_WITH_TBB="$tbb" -DCGAL_AHR_WITH_SHARED_COMPILATION="${SHARED:-OFF}" \
    -DCMAKE_COMPILE_WARNING_AS_ERROR=ON -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS=-O0 -DBUILD_TESTING=ON \
    > "$build_dir/$1.log" || status=$?
  if ((status == 0)); then
    cmake --build "$build_dir/$1" -j "${JOBS:-2}" --target "${targets[@]}" -- --keep-going >> "$build_dir/$1.log" 2>&1 || status=$?
  fi
  if ((status == 0)) && [[ -n ${TESTS:-} ]]; then
    (cd "$build_dir/$1" && ctest --output-on-failure --no-tests=error -R "$TESTS") >> "$build_dir/$1.log" 2>&1 || status=$?
  fi
  return $status
}

command -v apt-get > /dev/null || { echo "This is no Debian: CGAL's versions cannot be had"; exit 77; }
case ${1:-pairs} in
  pairs) configurations=("${pairs[@]}") ;;
  all) mapfile -t configurations < <(all_configurations) ;;
  *) configurations=("$@") ;;
esac
for configuration in "${configurations[@]}"; do
  all_configurations | grep --quiet --line-regexp --fixed-strings "$configuration" ||
    { echo "There is no configuration $configuration; there are:"; all_configurations; exit 2; }
done

install_packages
install_missing clang
mkdir -p "$build_dir"
failed=()
for configuration in "${configurations[@]}"; do
  SECONDS=0
  if build "$configuration"; then
    echo "  built in $SECONDS s"
  else
    echo "  FAILED after $SECONDS s; see $build_dir/$configuration.log"
    grep -E -A 5 'error:|tests failed' "$build_dir/$configuration.log" | head -n 40
    failed+=("$configuration")
  fi
done
echo "${#configurations[@]} configurations, ${#failed[@]} failed: ${failed[*]}"
((${#failed[@]} == 0))
