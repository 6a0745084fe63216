#!/usr/bin/env bash
# Newton's method in Fortran ends at the minimum that the example in C finds, where nothing pulls any more.
#   fortran_newton_ends.sh PROGRAM PROGRAM-IN-C
set -euo pipefail
least=$("$2" 0.05 5 | sed -n 's/^ends at energy \(.*\), gradient.*/\1/p')
"$1" | tee /dev/stderr | awk -v least="$least" '{ energy = $2; derivative = $3; steps = $1 }
  END { off = energy - least; exit !(off < 1e-9 && off > -1e-9 && derivative < 1e-12 && steps <= 40) }'
