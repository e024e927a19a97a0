#!/bin/bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# The program hde_remesh_mpi on 1, 2 and 3 ranks of this machine: the same bytes, faults, a killed rank.
#   test_hde_remesh_mpi.sh MPIRUN PROGRAM GENERATOR

if [ $# -ne 3 ] || [ ! -x "$2" ] || [ ! -x "$3" ]; then
  echo "usage: $0 MPIRUN PROGRAM GENERATOR" >&2
  exit 2
fi
mpirun=$1
mpi_program=$(realpath "$2")
generator=$(realpath "$3")
# shellcheck source=program_checks.sh
source "$(dirname "$0")/program_checks.sh"

# in containers tests run as root, and with fewer cores than ranks
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1

# program of `run`: the first argument is the number of ranks
cat >on_ranks <<END
#!/bin/bash
ranks=\$1
shift
exec "$mpirun" -n "\$ranks" "$mpi_program" "\$@"
END
chmod +x on_ranks
program=./on_ranks

# refuses RANKS TEXT ARGUMENTS...: the program fails with one line that contains the text, and the old output is intact
refuses() {
  local ranks=$1 text=$2
  shift 2
  echo "precious" >precious.ply
  check "refused on $ranks ranks: $*" run 1 "$ranks" "$@"
  check "names '$text'" says "$text"
  check "told once" test "$(grep -c '^hde_remesh_mpi: ' stderr)" = 1
  check "old output untouched" grep -qx precious precious.ply
  check "nothing left behind" test -z "$(find . -name '.precious*')"
}

"$generator" 40000 torus.ply >/dev/null || exit 2
options=(--faces 15000 --sigma .02 --piece 6000 --cell 4000 --threads 1)

check "one rank" run 0 1 torus.ply 1.ply "${options[@]}"
check "topology of the result" grep -qE '^result: .* 1 components, 0 boundary loops, Euler characteristic 0$' stdout
for ranks in 2 3; do
  check "$ranks ranks" run 0 "$ranks" torus.ply "$ranks.ply" "${options[@]}" --quiet
  check "the same bytes by $ranks ranks" cmp 1.ply "$ranks.ply"
  check "quiet" test ! -s stdout
done
check "nothing is left of the pieces" test -z "$(find . -name '.*pieces*')"

# faults
refuses 2 "cannot read 'none.ply'" none.ply precious.ply
head -c 400000 torus.ply >short.ply
refuses 2 "too short" short.ply precious.ply --quiet
# a face of four vertices in the second half, which only one rank reads; one of a vertex that is not there
size=$(stat -c %s torus.ply)
for byte in 04 03; do
  cp torus.ply corrupt.ply
  printf "\x$byte\xff\xff\xff\x7f" | dd of=corrupt.ply bs=1 seek=$((size - 13 * 5)) conv=notrunc status=none
  if [ $byte = 04 ]; then text="has 4 vertices"; else text="has the vertex 2147483647"; fi
  refuses 2 "$text" corrupt.ply precious.ply --quiet
done
refuses 3 "only .ply" torus.ply precious.obj --quiet
mkdir other && touch other/file
refuses 2 "not empty" torus.ply precious.ply --folder other --quiet
check "no such option" run 2 2 torus.ply out.ply --no-such-option
check "help" run 0 1 --help

# A rank is killed while it remeshes pieces: all end, with an error, and the old output is intact. The same command resumes.
echo "precious" >killed.ply
./on_ranks 2 torus.ply killed.ply "${options[@]}" --folder pieces --quiet >stdout 2>stderr &
run_of_all=$!
for ((i = 0; i < 600; ++i)); do
  [ -e pieces/done/pieces/0 ] && break
  sleep .1
done
check "a piece is done" test -e pieces/done/pieces/0
rank=$(pgrep -P $run_of_all -f hde_remesh_mpi | tail -1)
check "a rank to kill" kill -9 "$rank"
wait $run_of_all
status=$?
check "killed: an error" test $status -ne 0
check "killed: old output untouched" grep -qx precious killed.ply
check "another run is told" run 1 2 torus.ply killed.ply --faces 3000 --folder pieces --quiet
check "another run is named" says "another run"
check "resumed" run 0 3 torus.ply killed.ply "${options[@]}" --folder pieces --quiet
check "the same bytes after all" cmp 1.ply killed.ply

summary
