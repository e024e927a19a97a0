#!/usr/bin/env bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Runs hde_remesh on files as they come: cylinders, tubes, cones, elbows, plates and fillets of CAD programs, cracks of rounding,
# dialects of the formats, meshes far from the origin, outlines, walls, faces without area, noise. They are made by the benchmark;
# meshes given are tried, too, with options that users try, or with those behind a colon. Prints a line for each run: what was asked
# for and what came, distances both ways beside those of CGAL's edge collapse, boundary loops, components, intersections, time,
# memory, and what was said; marks what is beyond its limit, see benchmark_files.cpp. The exit status is 0 if nothing is. About eight
# minutes; with --all, which has more numbers of sides and rings, 30. --only GROUP makes one kind of them: cad, cracks, dialects,
# far, outlines, flaws, or none.
# Usage: scripts/benchmark_files.sh [--all] [--only GROUP] [MESH[:OPTIONS OF hde_remesh]...]
# For example: scripts/benchmark_files.sh --only none 'part.stl:--sharp 30 --faces 1000'
# BUILD_DIR (default build/benchmark) and JOBS (default 2) may be set in the environment.

set -euo pipefail
# relative to where the user is, not to the repository
options=()
cases=()
while (($# > 0)); do
  case $1 in
    --all) options+=("$1") ;;
    --only) options+=("$1" "$2") && shift ;;
    *:*) cases+=("$(realpath "${1%%:*}"):${1#*:}") ;;
    *) cases+=("$(realpath "$1")") ;;
  esac
  shift
done
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh

build_benchmark hde_remesh
hde_remesh=$program
build_benchmark benchmark_files
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
"$program" "${options[@]}" "$hde_remesh" "$folder" "${cases[@]}"
