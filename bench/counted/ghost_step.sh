#!/usr/bin/env bash
# Counts the instructions of a step with ghosts (ghost_step.c), and holds what the table of capi/guide/ghosts.md says: each
# number to a hundredth of it, and the step with most ghosts and own atoms selected to 30.5 million.
#   bash bench/counted/ghost_step.sh PROGRAM COUNTED_STAGES
#     COUNTED_STAGES  says how the library was built, and which code this processor runs
# Exit status 77, skipped: valgrind is not there, or the build is not that of the budgets.
set -euo pipefail
export LC_ALL=C
program=$(realpath "$1") stages=$(realpath "$2") here=$(cd "$(dirname "$0")" && pwd)
command -v valgrind >/dev/null || { echo "skipped: there is no valgrind here" && exit 77; }
[ "$("$stages" --build)" = "$(sed -n 's/^# build: //p' "$here/instruction_budgets.txt")" ] ||
  { echo "skipped: the budgets are for another build" && exit 77; }
[ "$(valgrind -q --tool=none "$stages" --code)" = wide ] || { echo "skipped: there is no AVX2 here" && exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The second step's dumps are the fourth to the sixth: ghosts, millions for the boundary and for all.
count() { # reach, what is selected
  valgrind --tool=callgrind --toggle-collect=counted_stage --zero-before=counted_stage --dump-after=counted_stage \
    --callgrind-out-file="$work/dump" "$program" "$1" "$2" >"$work/ghosts" 2>"$work/log" || { cat "$work/log" && exit 1; }
  sed -n 's/^totals: //p' "$work"/dump.{4,5,6} | awk -v ghosts="$(cat "$work/ghosts")" '
    { all += $1 } NR == 2 { boundary = $1 }
    END { if (NR != 3) exit 1; printf "%d %.2f %.2f\n", ghosts, boundary / 1e6, all / 1e6 }'
}
for reach in 10.9 6.8; do
  for what in all own; do echo "$(count $reach $what) $reach $what"; done
done | tee "$work/counted"

# The rows of the page, in this order: | what | boundary | step |
sed -nE 's/^\| (([0-9]+) ghosts within [0-9.]+ angstrom, all balls|the same, own atoms selected) \| ([0-9.]+) \| ([0-9.]+) \|$/\3 \4 \2/p' \
  "$here/../../capi/guide/ghosts.md" >"$work/page"
paste -d ' ' "$work/counted" "$work/page" | awk '
  function differs(counted, said) { return counted > 1.01 * said || counted < 0.99 * said }
  differs($2, $6) || differs($3, $7) || ($8 != "" && $8 != $1) { print "the page says otherwise: " $0; wrong = 1 }
  $4 == "10.9" && $5 == "own" && $3 > 30.5 { print "more than 30.5 million: " $3; wrong = 1 }
  END { exit wrong || NR != 4 }'
