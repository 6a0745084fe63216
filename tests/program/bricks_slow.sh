#!/usr/bin/env bash
# Ten million balls in bricks: a crystal of crambin, made on the fly by the example. No piece of it knows the answer, but every
# count is a cubic in the number of cells along an axis, as nothing reaches further than a cell: four small crystals tell
# what a large one has.
#   bricks_slow.sh EXAMPLE SOURCE-FOLDER WORK-FOLDER
set -euo pipefail
example=$1 source=$2 work=$3
export LC_ALL=C
rm -rf "$work"
mkdir -p "$work"
awk 'BEGIN { radius["C"] = 1.7; radius["N"] = 1.55; radius["O"] = 1.52; radius["S"] = 1.8 }
  /^(ATOM|HETATM)/ {
    element = substr($0, 77, 2)
    gsub(/ /, "", element)
    print substr($0, 31, 8), substr($0, 39, 8), substr($0, 47, 8), radius[element] + 0.7
  }' "$source/bench/molecules/crambin.pdb" >"$work/crambin.xyzr"

numbers() { # cells along each axis, and of a brick: all numbers that it prints
  "$example" "$work/crambin.xyzr" 30 19 23 "$1" "$1" "$1" "$2" 2>/dev/null | grep -oE -- '-?[0-9]+(\.[0-9]+)?' | xargs
}
large=32
for k in 2 3 4 5; do echo "$k $(numbers $k 2)"; done >"$work/small"
numbers $large 8 >"$work/large"
cat "$work/small" "$work/large"
# By Lagrange: weights of values at 2, 3, 4 and 5. Counts are exact; areas and volumes have the rounding of the small ones,
# which the weights enlarge.
awk -v x=$large '
  NR <= 4 {
    weight = 1
    for (k = 2; k <= 5; ++k) if (k != $1) weight *= (x - k) / ($1 - k)
    for (i = 2; i <= NF; ++i) foretold[i - 1] += weight * $i
    next
  }
  {
    if (NF != 9) { print NF " numbers"; exit 1 }
    for (i = 1; i <= NF; ++i) {
      difference = foretold[i] - $i
      if (difference < 0) difference = -difference
      if (difference > (i <= 6 ? 0.25 : 1e-9 * (1 + $i))) { printf "number %d: %s instead of %.6f\n", i, $i, foretold[i]; bad = 1 }
    }
    if ($1 < 10000000) { print "only " $1 " balls"; bad = 1 }
    exit bad
  }' "$work/small" "$work/large"
