#!/usr/bin/env bash
# The record of fuzzing: executions, seconds, inputs in the corpus and compiler of each harness of the core, by
# libFuzzer and on random inputs, without and with sanitizers, added up over runs; a file for each version in
# fuzz/record. The harness slow_sets is left out: it takes seconds for a set and looks for the few that are slow.
#   record.sh                           whether each has a million without and a hundred thousand with sanitizers
#   record.sh none SECONDS [AREA...]    libFuzzer runs all, or these, for so long each, one after the other; this is added
#   record.sh none COUNT-random [AREA...]    each takes so many random inputs that it has not had
#   record.sh address,undefined ...     the same with these sanitizers
# Builds lie in build/fuzz_*; corpora grow in build/fuzz_found. A run that finds a failing input adds nothing.
set -euo pipefail
cd "$(dirname "$0")/.."
export LC_ALL=C
version=$(sed -n 's/.*HSP_VERSION_STRING "\(.*\)".*/\1/p' include/hardsphere/version.h)
record=fuzz/record/$version.csv
harnesses=$(sed -nE 's/^hsp_fuzz_harness\(([a-z_]+) [0-9]+ ([0-9]+).*/\1 \2/p' fuzz/CMakeLists.txt)
if [ $# -eq 0 ]; then
  awk -F '[, ]' -v OFS=, '
    NR == FNR { done[$1, $2] += $4; next }
    { for (kind in least) if (done[$1, kind] < least[kind]) { print $1, kind, done[$1, kind] + 0 " of " least[kind]; short = 1 } }
    BEGIN { least["none"] = 1000000; least["address+undefined"] = 100000 }
    END { exit short }' "$record" - <<<"$harnesses"
  exit
fi

sanitizers=$1 seconds=$2 inputs=libFuzzer
shift 2
if [ $# -gt 0 ]; then harnesses=$(grep -E "^($(tr ' ' '|' <<<"$*")) " <<<"$harnesses"); fi
if [[ $seconds == *-random ]]; then inputs=random count=${seconds%-random}; fi
build=build/fuzz_${inputs}_${sanitizers//,/_}
options=()
if [ "$sanitizers" != none ]; then options=("-DHSP_SANITIZE=$sanitizers" -DHSP_CHECKED_LIBRARY=ON); fi
if [ $inputs = libFuzzer ]; then
  options=("${options[@]}" -DHSP_FUZZ_ENGINE=ON "-DHSP_SANITIZE=fuzzer-no-link${options:+,$sanitizers}")
fi
cmake -G Ninja -S . -B "$build" -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=RelWithDebInfo \
  -DHSP_FUZZ=ON -DHSP_TESTS=OFF -DHSP_BENCH=OFF -DHSP_FORTRAN=OFF -DHSP_INSTALL=OFF -DHSP_TOOL=OFF \
  -DHSP_COMPONENTS= "${options[@]}" >/dev/null
compiler=$(clang++ --version | sed -nE '1s/.*clang version ([0-9.]+).*/clang \1/p')
[ -e "$record" ] || echo harness,sanitizers,inputs,executions,seconds,corpus,compiler >"$record"
while read -r area longest; do
  row=$area,${sanitizers//,/+},$inputs corpus=0 log=$build/$area.log
  begun=$SECONDS
  if [ $inputs = random ]; then
    ninja -C "$build" "fuzz_$area" >/dev/null
    begun=$SECONDS
    seed=$(awk -F, -v row="$row," 'index($0, row) == 1 { done = $4 } END { print done + 1 }' "$record")
    "$build/fuzz/fuzz_$area" --seed "$seed" --random "$count" --longest "$longest" >"$log" 2>&1 || { tail -n 30 "$log" && exit 1; }
    executions=$(sed -n 's/ inputs$//p' "$log")
  else
    ninja -C "$build" "libfuzzer_$area" >/dev/null
    begun=$SECONDS
    found=build/fuzz_found/$area
    mkdir -p "$found"
    "$build/fuzz/libfuzzer_$area" -max_len="$longest" -max_total_time="$seconds" -use_value_profile=1 -timeout=300 \
      -rss_limit_mb=4096 -print_final_stats=1 -artifact_prefix="$build/" "$found" "fuzz/corpus/$area" >"$log" 2>&1 ||
      { tail -n 30 "$log" && exit 1; }
    executions=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
    corpus=$(find "$found" "fuzz/corpus/$area" -type f | wc -l)
  fi
  awk -F, -v OFS=, -v row="$row" -v executions="$executions" -v seconds=$((SECONDS - begun)) -v compiler="$compiler" \
    -v corpus="$corpus" '
    $1 "," $2 "," $3 == row { executions += $4; seconds += $5; next }
    { print }
    END { print row, executions, seconds, corpus, compiler }' "$record" >"$record.new"
  mv "$record.new" "$record"
  echo "$row: $executions executions"
done <<<"$harnesses"
