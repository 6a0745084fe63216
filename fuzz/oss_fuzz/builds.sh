#!/usr/bin/env bash
# The harnesses are made as OSS-Fuzz makes them, and each runs its corpus.
#   builds.sh SOURCE-FOLDER WORK-FOLDER
set -euo pipefail
work=$2
for program in clang++ zip unzip; do command -v "$program" >/dev/null || { echo "no $program" && exit 77; }; done
rm -rf "$work/out"
mkdir -p "$work/out" "$work/src"
ln -sfn "$1" "$work/src/hardsphere"
flags="-O1 -gline-tables-only -fsanitize=address -fsanitize=fuzzer-no-link"
SRC=$work/src WORK=$work OUT=$work/out CC=clang CXX=clang++ CFLAGS=$flags CXXFLAGS=$flags LIB_FUZZING_ENGINE=-fsanitize=fuzzer \
  bash "$1/fuzz/oss_fuzz/build.sh" >"$work/log" 2>&1 || { tail -n 30 "$work/log" && exit 1; }
for corpus in "$work"/out/*_seed_corpus.zip; do
  area=$(basename "$corpus" _seed_corpus.zip)
  unzip -qo "$corpus" -d "$work/out/$area.inputs"
  "$work/out/$area" -runs=0 "$work/out/$area.inputs" >"$work/log" 2>&1 || { tail -n 30 "$work/log" && exit 1; }
done
[ "$(ls "$work"/out/*.options | wc -l)" -eq 8 ] || { echo "some are not there" && exit 1; }
