#!/usr/bin/env bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Remeshing in pieces, measured. First beside the serial run: CGAL's bunny resampled, to half of its faces in 16 pieces. Then the
# same by hde_remesh_mpi on 1, 2, 3 and 4 ranks of this machine, whose results must have the same bytes. At last a large torus on
# one rank: its memory, and the time for a face.
# Usage: scripts/benchmark_pieces.sh [FACES_OF_BUNNY [FACES_OF_TORUS]], by default 2000000 and 50000000. Some hours; both are to be
# much smaller for a first look.
# BUILD_DIR (default build/benchmark) and JOBS (default 2) may be set in the environment.

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
faces_of_bunny=${1:-2000000}
faces_of_torus=${2:-50000000}

install_missing libboost-mpi-dev openmpi-bin time
build_benchmark benchmark_pieces
cmake --build "$build_dir" --target hde_remesh_mpi write_bumpy_torus -j "${JOBS:-2}"
mpi_program=$(find "$build_dir" -name hde_remesh_mpi -type f -perm -u+x)
generator=$(find "$build_dir" -name write_bumpy_torus -type f -perm -u+x)
folder=$(mktemp -d -p "$build_dir")
trap 'rm -rf "$folder"' EXIT
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1

"$program" "$data/bunny00.off" "$faces_of_bunny" 16 "$folder/bunny.ply"

echo
echo "On 1, 2, 3 and 4 ranks of one thread"
for ranks in 1 2 3 4; do
  mpirun -n "$ranks" "$mpi_program" "$folder/bunny.ply" "$folder/$ranks.ply" --faces $((faces_of_bunny / 2)) --sigma .02 \
    --piece $((faces_of_bunny * 21 / 320)) --threads 1 2> "$folder/progress" | tail -1
  cmp "$folder/1.ply" "$folder/$ranks.ply" && echo "  the bytes are those of one rank"
done

echo
echo "A torus of $faces_of_torus faces on one rank, to half of them"
"$generator" "$faces_of_torus" "$folder/torus.ply" > /dev/null
command time -f '%e s, %M kB at most' mpirun -n 1 "$mpi_program" "$folder/torus.ply" "$folder/out.ply" \
  --faces $((faces_of_torus / 2)) --sigma .01 --memory 2G
