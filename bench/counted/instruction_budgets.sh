#!/usr/bin/env bash
# Counts what each stage of the library costs and compares it with the budgets in instruction_budgets.txt: instructions
# and mispredicted branches per ball, in a processor that valgrind simulates, so that neither the machine nor its load
# matters. Both kinds of code have budgets, that for AVX2 and that for every processor (target counted_stages_scalar, which
# is built only when it is named). More than 5 % over a budget fails, and so does more than 5 % under: the better number is
# to be kept.
#   bash bench/counted/instruction_budgets.sh build/dev/bench/counted_stages [--write]
#     --write  writes what is counted as the new budgets, of both kinds
# Exit status 77, skipped: valgrind is not there, or the program was not built as the budgets' was.
set -euo pipefail
export LC_ALL=C
case $#:${2:-} in
  1: | 2:--write) ;;
  *) sed -n '2,10s/^# //p' "$0" >&2 && exit 2 ;;
esac
program=$(realpath "$1")
budgets=$(cd "$(dirname "$0")" && pwd)/instruction_budgets.txt

command -v valgrind >/dev/null || { echo "skipped: there is no valgrind here" && exit 77; }
build=$("$program" --build)
budgets_build=$(sed -n 's/^# build: //p' "$budgets" 2>/dev/null || true)
if [ "${2:-}" != --write ] && [ "$build" != "$budgets_build" ]; then
  printf 'skipped: the budgets are for another build\n  budgets: %s\n  program: %s\n' "$budgets_build" "$build"
  exit 77
fi

# Functions of the interface and those of the z-buffer switch counting on and off, so what the program itself does is
# not in it.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
run() {
  rm -f "$work"/dump*
  valgrind --tool=callgrind --branch-sim=yes --toggle-collect='hsp_*' \
    --toggle-collect='bench::AnalyticZBuffer::draw*' --toggle-collect='bench::Placement::place*' \
    --zero-before=counted_stage --dump-after=counted_stage --dump-line=no --compress-strings=no --compress-pos=no \
    --callgrind-out-file="$work/dump" "$1" >"$work/stages" 2>"$work/log" || { cat "$work/log" && exit 1; }

  # The n-th dump belongs to the n-th line that the program printed. Costs are lines of numbers under the object file
  # that spent them; what stands behind `calls=` is the sum over a callee, which has lines of its own. Other object files
  # are left out: the C library chooses among several memmove and memset by the processor.
  n=0
  while read -r stage molecule surface balls; do
    n=$((n + 1))
    awk -v row="$stage $molecule $surface $2" -v balls="$balls" -v object="ob=$1" '
      /^events:/ && $0 != "events: Ir Bc Bcm Bi Bim" { print "unknown events: " $0 > "/dev/stderr"; exit 1 }
      /^ob=/ { ours = $0 == object }
      /^calls=/ { getline; next }
      /^[0-9]/ && ours { instructions += $2; mispredictions += $4 + $6 }
      END { printf "%s %.1f %.2f\n", row, instructions / balls, mispredictions / balls }' "$work/dump.$n"
  done <"$work/stages"
}
code=$(valgrind -q --tool=none "$program" --code)
if [ "${2:-}" = --write ]; then
  for each in "$program" "${program}_scalar"; do
    [ -x "$each" ] || { echo "build it first: $each" >&2 && exit 2; }
  done
  [ "$code" = wide ] || { echo "there is no AVX2 here: half of the budgets would go" >&2 && exit 2; }
fi
run "$program" "$code" >"$work/counted"
if [ "${2:-}" = --write ]; then run "${program}_scalar" scalar >>"$work/counted"; fi
n=$(wc -l <"$work/counted")
[ "$n" -gt 0 ] || { echo "nothing was counted" && exit 1; }

if [ "${2:-}" = --write ]; then
  {
    sed '/^#/!d; /^# build: /d; /^# stage /d' "$budgets"
    echo "# build: $build"
    awk 'BEGIN { print "# stage          molecule      surface            code    instructions  mispredictions" }
      { printf "%-16s %-13s %-18s %-6s %13s %15s\n", $1, $2, $3, $4, $5, $6 }' "$work/counted"
  } >"$work/new"
  cp "$work/new" "$budgets"
  echo "written: $budgets"
  exit
fi

awk '
  function judge(counted, budget) {
    if (counted > 1.05 * budget) { ++over; return "OVER" }
    if (counted < 0.95 * budget) { ++under; return "UNDER" }
    return ""
  }
  FNR == NR { if (!/^#/) { instructions[$1 " " $2 " " $3 " " $4] = $5; mispredictions[$1 " " $2 " " $3 " " $4] = $6 } next }
  FNR == 1 { printf "%-57s %12s %12s %9s %9s\n", "per ball", "instructions", "budget", "mispred.", "budget" }
  {
    key = $1 " " $2 " " $3 " " $4
    seen[$4] = 1
    if (!(key in instructions)) { print key ": no budget"; ++unknown; next }
    printf "%-57s %12.1f %12.1f %9.2f %9.2f", key, $5, instructions[key], $6, mispredictions[key]
    print "  " judge($5, instructions[key]) "  " judge($6, mispredictions[key])
    delete instructions[key]
  }
  END {
    # The code of the one program alone may have been counted: that of the processor.
    for (key in instructions) {
      split(key, word, " ")
      if (word[4] in seen) { print key ": has a budget, but was not counted"; ++unknown }
    }
    if (over) print over " numbers are more than 5 % over their budgets"
    if (under) print under " numbers are more than 5 % under their budgets: keep them with"
    if (under || unknown) print "  bash bench/counted/instruction_budgets.sh PROGRAM --write"
    exit over + under + unknown > 0
  }' "$budgets" "$work/counted"
