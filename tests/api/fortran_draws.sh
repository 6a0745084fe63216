#!/usr/bin/env bash
# The Fortran example writes a picture of its twelve balls through its own sink: well-formed, a path for each ball.
#   fortran_draws.sh PROGRAM WORK-FOLDER
set -euo pipefail
program=$1 work=$2
mkdir -p "$work"
rm -f "$work/ring.svg"
"$program" "$work/ring.svg"
xmllint --noout "$work/ring.svg"
paths=$(grep -c ' data-ball=' "$work/ring.svg")
colours=$(grep -o ' data-ball="[0-9]*"[^>]*fill="#[0-9a-fA-F]*"' "$work/ring.svg" | sed 's/.*fill=//' | sort -u | wc -l)
[ "$paths" -eq 12 ] || { echo "$paths paths for 12 balls" && exit 1; }
[ "$colours" -eq 12 ] || { echo "$colours colours for 12 chains" && exit 1; }
# Where it cannot write it says so.
if "$program" "$work/no_such_folder/ring.svg" 2>"$work/errors"; then echo "nothing was written, and nobody said so" && exit 1; fi
grep -q 'cannot write' "$work/errors" || { cat "$work/errors" && exit 1; }
echo "$paths paths"
