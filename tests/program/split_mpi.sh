#!/usr/bin/env bash
# The example of MPI: with several ranks it prints what it prints with one, finds each ball's bits and the totals of one
# piece, and its totals are crambin's. Areas that it writes are the same bytes.
#   split_mpi.sh RANKS SOURCE-FOLDER WORK-FOLDER SPLIT-MPI MPIEXEC
# Exit status 77: MPI does not start processes here.
set -euo pipefail
ranks=$1 source=$2 work=$3 program=$4 mpiexec=$5
export LC_ALL=C OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
mkdir -p "$work"
"$mpiexec" -n 1 true >"$work/log" 2>&1 || { echo "skipped: $(grep -m 1 . "$work/log")" && exit 77; }

# Crambin, by the radii of the table in README.md.
awk 'BEGIN { radius["C"] = 1.7; radius["N"] = 1.55; radius["O"] = 1.52; radius["S"] = 1.8 }
  /^(ATOM|HETATM)/ {
    element = substr($0, 77, 2)
    gsub(/ /, "", element)
    print substr($0, 31, 8), substr($0, 39, 8), substr($0, 47, 8), radius[element]
  }' "$source/bench/molecules/crambin.pdb" >"$work/crambin.xyzr"

# Eight balls of a cube around a void, which all of up to eight ranks share.
for x in -1 1; do for y in -1 1; do for z in -1 1; do echo "$x $y $z 1.5"; done; done; done >"$work/cube.xyzr"

# Small balls at one end and large ones at the other: parts on their own would not have the lattice of the whole.
awk 'BEGIN { for (i = 0; i < 120; ++i) printf "%.12f %.12f %.12f %.12f\n", 0.9 * i, sin(i), cos(1.7 * i), 0.2 + i / 70 }' \
  >"$work/growing.xyzr"

# Points, two of which are one on the lattice of the whole.
printf '0 0 0 0\n1 0 0 0\n1.000000001 0 0 0\n2 0 0 0\n' >"$work/points.xyzr"

for balls in "$work/crambin.xyzr" "$work/growing.xyzr" "$work/cube.xyzr" "$work/points.xyzr" \
  "$source/tests/portability/inputs/degenerate.xyzr" \
  "$source/tests/program/inputs/good/corners.xyzr"; do
  "$mpiexec" -n 1 "$program" "$balls" >"$work/one" 2>"$work/log" || { cat "$work/log" && exit 1; }
  "$mpiexec" -n "$ranks" "$program" "$balls" check >"$work/several" 2>"$work/log" || { cat "$work/log" && exit 1; }
  diff "$work/one" "$work/several" || { echo "$balls: $ranks ranks find something else than one" && exit 1; }
  "$mpiexec" -n 1 "$program" "$balls" "$work/one.areas" >/dev/null 2>&1
  "$mpiexec" -n "$ranks" "$program" "$balls" "$work/several.areas" >/dev/null 2>&1
  cmp "$work/one.areas" "$work/several.areas"
  [ "$(stat -c %s "$work/one.areas")" -eq $((8 * $(cut -d ' ' -f 1 "$work/one"))) ]
  echo "$(cat "$work/several"); $(cat "$work/log")"
  if [[ $balls == *crambin* ]]; then
    grep -qE '^327 balls, area 4247\.65621155.*, volume 3571\.70310903' "$work/several"
    # Each rank has something to do, and neighbours.
    grep -qE "^$ranks ranks, [1-9][0-9]+ balls in halos, [1-9][0-9]+ bytes" "$work/log"
  fi
  if [[ $balls == *points* ]]; then grep -q ', 3 components, ' "$work/several"; fi
  if [[ $balls == *cube* ]]; then grep -qE ', 1 components, 1 voids, Euler number 4$' "$work/several"; fi
done

# A ball without a place is refused, and not left out; so is a file that cannot be written.
printf '0 0 0 1\n1 nan 0 1\n' >"$work/nowhere.xyzr"
if "$mpiexec" -n "$ranks" "$program" "$work/nowhere.xyzr" >"$work/several" 2>"$work/log"; then
  echo "taken without its second ball: $(cat "$work/several")" && exit 1
fi
grep -q '^split_mpi: ball 1: a value is NaN or infinite$' "$work/log"
if "$mpiexec" -n "$ranks" "$program" "$work/cube.xyzr" "$work/none/areas" >/dev/null 2>"$work/log"; then exit 1; fi
grep -q '^split_mpi: rank 0 cannot write .*none/areas$' "$work/log"
