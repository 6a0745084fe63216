#!/usr/bin/env bash
# The harnesses of the core for OSS-Fuzz, which says by the environment how: CC, CXX, CFLAGS, CXXFLAGS, LIB_FUZZING_ENGINE,
# and where: SRC, WORK, OUT.
set -euo pipefail
source=$SRC/hardsphere
cmake -G Ninja -S "$source" -B "$WORK/build" -DCMAKE_BUILD_TYPE=RelWithDebInfo -DHSP_FUZZ=ON -DHSP_FUZZ_ENGINE=ON \
  -DHSP_FUZZ_ENGINE_LINKED="$LIB_FUZZING_ENGINE" -DHSP_CHECKED_LIBRARY=ON -DHSP_TESTS=OFF -DHSP_BENCH=OFF -DHSP_FORTRAN=OFF \
  -DHSP_INSTALL=OFF -DHSP_TOOL=OFF -DHSP_COMPONENTS=
sed -nE 's/^hsp_fuzz_harness\(([a-z_]+) [0-9]+ ([0-9]+).*/\1 \2/p' "$source/fuzz/CMakeLists.txt" |
  while read -r area longest; do
    ninja -C "$WORK/build" "libfuzzer_$area"
    cp "$WORK/build/fuzz/libfuzzer_$area" "$OUT/$area"
    zip -qj "$OUT/${area}_seed_corpus.zip" "$source/fuzz/corpus/$area"/*
    printf '[libfuzzer]\nmax_len = %s\n' "$longest" >"$OUT/$area.options"
  done
