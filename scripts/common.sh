# shellcheck shell=bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Functions for the scripts beside this file, which source it.

# install_packages: what the package is built and tested with
install_packages() {
  install_missing g++ cmake make ccache libcgal-dev libcgal-demo libeigen3-dev libtbb-dev libcli11-dev nlohmann-json3-dev
}

# install_missing NAME...: those of the packages that are not there, by apt-get
install_missing() {
  local wanted=("$@") missing=() name
  if ! command -v apt-get > /dev/null; then
    echo "This is no Debian: make sure that the counterparts of these packages are installed: ${wanted[*]}" >&2
    return
  fi
  for name in "${wanted[@]}"; do
    if [[ "$(dpkg-query -W -f '${db:Status-Status}' "$name" 2> /dev/null)" != installed ]]; then
      missing+=("$name")
    fi
  done
  if ((${#missing[@]} > 0)); then
    echo "Installing ${missing[*]}"
    [[ -n ${packages_are_listed:-} ]] || as_root apt-get update
    packages_are_listed=yes
    as_root env DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends "${missing[@]}"
  fi
}

# can_be_installed NAME VERSION: whether apt-get has the package in a version that begins so
can_be_installed() {
  if ! command -v apt-cache > /dev/null; then
    return 1
  fi
  apt-cache policy "$1" | grep -Eq "Candidate: ([0-9]+:)?$2[^0-9]"
}

as_root() {
  if ((EUID == 0)); then
    "$@"
  else
    sudo "$@"
  fi
}

# unpack_cgal_data BUILD_DIR: Small images of Debian install packages without /usr/share/doc, where libcgal-demo has its
# meshes. Then the package is unpacked into the build folder, where CMake looks for it.
unpack_cgal_data() {
  local build_dir=$1 download_dir
  if compgen -G '/usr/share/doc/libcgal*/data.tar*' > /dev/null || [[ -n "${CGAL_DATA_DIR:-}" ]] ||
    compgen -G "$build_dir/libcgal-demo/usr/share/doc/libcgal*/data.tar*" > /dev/null ||
    ! command -v apt-get > /dev/null; then
    return
  fi
  echo "Unpacking the meshes of libcgal-demo"
  mkdir -p "$build_dir"
  download_dir=$(mktemp -d)
  chmod 755 "$download_dir"
  (cd "$download_dir" && (apt-get download libcgal-demo || (as_root apt-get update && apt-get download libcgal-demo)))
  dpkg-deb --extract "$download_dir"/libcgal-demo_*.deb "$build_dir/libcgal-demo"
  rm -r "$download_dir"
}

# cgal_data_dir BUILD_DIR: the folder of CGAL's data that CMake has found
cgal_data_dir() {
  sed -n 's/^CGAL_AHR_DATA_DIR:INTERNAL=//p' "$1/CMakeCache.txt"
}

# build_benchmark NAME [CMAKE_OPTION...]: sets build_dir, program, and data, the folder of CGAL's meshes
build_benchmark() {
  build_dir=${BUILD_DIR:-build/benchmark}
  install_packages
  unpack_cgal_data "$build_dir"
  cmake -Wno-dev -S . -B "$build_dir" -DCMAKE_BUILD_TYPE=Release -DCGAL_AHR_NATIVE=ON -DBUILD_TESTING=OFF "${@:2}"
  cmake --build "$build_dir" --target "$1" -j "${JOBS:-2}"
  program=$(find "$build_dir" -name "$1" -type f -perm -u+x)
  data=$(cgal_data_dir "$build_dir")/meshes
}

# absolute_paths FILE...: sets meshes to the files, which are relative to where the user is, not to the repository
absolute_paths() {
  meshes=()
  local file
  for file in "$@"; do
    meshes+=("$(realpath "$file")")
  done
}

phases=()

# phase NAME COMMAND...: runs it, and remembers for print_phases how long that took. `phase ... ||` goes on where it fails.
phase() {
  local name=$1 began=$SECONDS processor_began status
  processor_began=$(processor_seconds)
  shift
  echo "==== $name"
  "$@"
  status=$?
  phases+=("$(printf '%8d s %8d s   %s' $((SECONDS - began)) $(($(processor_seconds) - processor_began)) "$name")")
  return $status
}

# processor_seconds: of this script and of what it has run; 0 where there is no /proc
processor_seconds() {
  awk '{ print int(($14 + $15 + $16 + $17) / 100) }' "/proc/$$/stat" 2> /dev/null || echo 0
}

print_phases() {
  echo "    time  processor   phase"
  printf '%s\n' "${phases[@]}"
  printf '%8d s %8d s   all\n' $SECONDS "$(processor_seconds)"
}
