#!/usr/bin/env bash
# The plan of the search in lib/README.md has the counts of the budgets: of each stage that it names, those of registers
# of 16 and of 32 bytes in instruction_budgets.txt, and for one number at a time what the share in target_budgets.txt
# says, where there is one. More than 5 % off fails, as for the budgets themselves.
#   plan_counts.sh SOURCE-FOLDER
set -euo pipefail
cd "$1"
awk '
  FILENAME ~ /instruction_budgets/ { if ($2 == "crambin") budget[$1, $3, $4] = $5; next }
  FILENAME ~ /target_budgets/ { if ($3 == "sse2") share[$1, $2] = $5; next }
  /^## / { inside = /^## The plan of the search/ }
  !inside || !/^\|/ { next }
  {
    split($0, cell, /[ ]*\|[ ]*/)
    stage = cell[5]
    if (stage !~ /^`/) next
    gsub(/`/, "", stage)
    surface = stage ~ /^view/ ? "van_der_waals" : "solvent_accessible"
    ++rows
    compare(stage ", 16 bytes", cell[7], budget[stage, surface, "scalar"])
    compare(stage ", 32 bytes", cell[8], budget[stage, surface, "wide"])
    if ((stage, surface) in share) {
      ++shares
      compare(stage ", one at a time", cell[6], budget[stage, surface, "scalar"] / share[stage, surface])
    }
  }
  function compare(what, here, counted) {
    if (counted > 0 && here > 0.95 * counted && here < 1.05 * counted) return
    print "lib/README.md, " what ": " here ", counted are " counted
    failed = 1
  }
  END {
    if (rows < 5 || shares < 3) { print "only " rows " rows and " shares " shares were found"; failed = 1 }
    if (!failed) print rows " stages, " shares " of them one number at a time as well"
    exit failed
  }' bench/counted/instruction_budgets.txt bench/counted/target_budgets.txt lib/README.md
