#!/usr/bin/env bash
# The example of a minimisation goes downhill in every step until nothing pulls any more.
#   minimise_descends.sh PROGRAM
set -euo pipefail
"$1" | tee /dev/stderr | awk '
  NR == 1 { if ($0 !~ /^step +energy +derivative +length$/) wrong = "the heading is " $0; next }
  NF != 4 || $1 != NR - 2 { wrong = "not the line of step " NR - 2 ": " $0; exit }
  NR == 2 { first = $2 }
  NR > 2 && $2 > energy { wrong = "step " $1 " goes uphill"; exit }
  NR > 2 && $4 <= 0 { wrong = "step " $1 " goes nowhere"; exit }
  { energy = $2; derivative = $3; steps = $1 }
  END {
    if (wrong == "" && steps < 10) wrong = "only " steps " steps"
    if (wrong == "" && first - energy < 0.01 * first) wrong = "hardly any energy was lost"
    if (wrong == "" && !(derivative < 1e-5)) wrong = "something still pulls: " derivative
    if (wrong != "") { print wrong; exit 1 }
    print steps " steps, from " first " to " energy
  }'
