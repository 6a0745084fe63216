#!/usr/bin/env bash
# Counts the instructions of queries and of Steps 1 and 2 on crambin for targets other than AVX2 and compares them with the
# budgets in target_budgets.txt. Programs for each target run in QEMU's user mode, where a plugin counts, the same number
# in every run. More than 5 % over or under a budget fails, and so does a share of the scalar instructions above what
# it may be at most; those were counted when the budgets were written.
#   bash bench/counted/target_budgets.sh build/dev/bench/counted_stages WORK-FOLDER [--write]
#     --write  writes what is counted as the new budgets, with scalar code counted anew
# Exit status 77, skipped: a compiler or emulator is missing here, or is not the one of the budgets.
set -euo pipefail
export LC_ALL=C
case $#:${3:-} in
  2: | 3:--write) ;;
  *) sed -n '2,9s/^# //p' "$0" >&2 && exit 2 ;;
esac
native=$1 work=$2
here=$(cd "$(dirname "$0")" && pwd)
budgets=$here/target_budgets.txt
for program in g++ aarch64-linux-gnu-g++ qemu-x86_64 qemu-aarch64; do
  command -v $program >/dev/null || { echo "skipped: there is no $program here" && exit 77; }
done
compilers="g++ $(g++ -dumpversion) aarch64-linux-gnu-g++ $(aarch64-linux-gnu-g++ -dumpversion)"
budgets_compilers=$(sed -n 's/^# compilers: //p' "$budgets" 2>/dev/null || true)
if [ -z "${3:-}" ] && [ "$compilers" != "$budgets_compilers" ]; then
  printf 'skipped: the budgets are for other compilers\n  budgets: %s\n  here: %s\n' "$budgets_compilers" "$compilers"
  exit 77
fi

rm -rf "$work"
mkdir -p "$work"
build() {
  "$@" >>"$work/log" 2>&1 || { tail -n 40 "$work/log" && exit 1; }
}
build gcc -O2 -shared -fPIC -o "$work/count.so" "$here/targets/count_instructions.c"
"$native" --balls >"$work/balls"

# count EMULATOR TARGETS CMAKE-OPTION...: builds a program for each target and prints its rows.
count() {
  local emulator=$1 targets=$2 target
  shift 2
  build cmake -S "$here/targets" -B "$work/$emulator" -DCMAKE_BUILD_TYPE=Release -DHSP_COUNTED_TARGETS="$targets" "$@"
  build cmake --build "$work/$emulator" --parallel 2
  for target in ${targets//;/ }; do
    "$emulator" -plugin "file=$work/count.so,counts=$work/counts" "$work/$emulator/counted_$target" "$work/balls" \
      >"$work/stages"
    paste -d ' ' "$work/stages" "$work/counts" |
      awk -v code="$emulator $target" '{ printf "%s %s %s %.1f\n", $1, $3, code, $5 / $4 }'
    rm "$work/counts"
  done
}
scalar=''
[ -z "${3:-}" ] || scalar='scalar;'
{
  count qemu-x86_64 "${scalar}sse2;x86_64_v2" -DCMAKE_C_COMPILER=gcc -DCMAKE_CXX_COMPILER=g++
  count qemu-aarch64 "${scalar}neon" -DCMAKE_C_COMPILER=aarch64-linux-gnu-gcc \
    -DCMAKE_CXX_COMPILER=aarch64-linux-gnu-g++ -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64
} >"$work/counted"

if [ -n "${3:-}" ]; then
  {
    sed '/^#/!d; /^# compilers: /d; /^# stage /d' "$budgets"
    echo "# compilers: $compilers"
    echo "# stage          surface            target    instructions  of scalar  at most"
    awk '
      $4 == "scalar" { scalar[$1 $2 $3] = $5; next }
      {
        most = $2 == "van_der_waals" ? 1 : $4 == "sse2" ? 0.78 : $1 == "boundary" ? 0.54 : 0.55
        printf "%-16s %-18s %-9s %12.1f %10.3f %8.2f\n", $1, $2, $4, $5, $5 / scalar[$1 $2 $3], most
      }' "$work/counted"
  } >"$work/new"
  cp "$work/new" "$budgets"
  echo "written: $budgets"
  exit
fi

awk '
  FNR == NR { if (!/^#/) { budget[$1 " " $2 " " $3] = $4; share[$1 " " $2 " " $3] = $5; most[$1 " " $2 " " $3] = $6 } next }
  FNR == 1 { printf "%-50s %12s %12s %10s %8s\n", "per ball or query", "instructions", "budget", "of scalar", "at most" }
  {
    key = $1 " " $2 " " $4
    if (!(key in budget)) { print key ": no budget"; ++wrong; next }
    now = $5 * share[key] / budget[key]
    verdict = now > most[key] ? "TOO MUCH" : $5 > 1.05 * budget[key] ? "OVER" : $5 < 0.95 * budget[key] ? "UNDER" : ""
    printf "%-50s %12.1f %12.1f %10.3f %8.2f  %s\n", key, $5, budget[key], now, most[key], verdict
    wrong += verdict != ""
    delete budget[key]
  }
  END {
    for (key in budget) { print key ": has a budget, but was not counted"; ++wrong }
    if (wrong) print "numbers that are better, or worse for a reason, are kept with --write"
    exit wrong > 0
  }' "$budgets" "$work/counted"
