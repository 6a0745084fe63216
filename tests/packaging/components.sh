#!/usr/bin/env bash
# The library with a part of its components: no part needs another that was left out.
#   components.sh SOURCE-FOLDER WORK-FOLDER C-COMPILER C++-COMPILER
set -euo pipefail
export LC_ALL=C
source=$1 work=$2 cc=$3 cxx=$4
rm -rf "$work"
mkdir -p "$work"
for components in none smooth space sight; do
  build=$work/$components
  {
    cmake -S "$source" -B "$build" -DCMAKE_C_COMPILER="$cc" -DCMAKE_CXX_COMPILER="$cxx" -DCMAKE_BUILD_TYPE=Release \
      -DCMAKE_CXX_FLAGS_RELEASE=-O0 -DHSP_COMPONENTS="${components#none}" -DHSP_WERROR=ON -DHSP_TOOL=OFF -DHSP_TESTS=OFF \
      -DHSP_BENCH=OFF -DHSP_FUZZ=OFF -DHSP_FORTRAN=OFF && cmake --build "$build" --parallel 2
  } >"$work/log" 2>&1 || { tail -n 40 "$work/log" && exit 1; }
  # With all objects linked, nothing of the library is missing; a program that measures areas links without them.
  "$cc" -r -nostdlib -o "$work/whole.o" -Wl,--whole-archive "$build/libhardsphere.a" -Wl,--no-whole-archive
  missing=$(nm -u "$work/whole.o" | grep -E 'hsp' || true)
  [ -z "$missing" ] || { printf '%s: missing\n%s\n' "$components" "$missing" && exit 1; }
  "$cc" -std=c99 -I"$source/include" "$source/capi/examples/minimal.c" "$build/libhardsphere.a" -lm -o "$work/minimal"
  "$work/minimal" >/dev/null
  echo "$components: $(stat -c %s "$build/libhardsphere.a") bytes"
done
if cmake -S "$source" -B "$work/program" -DHSP_COMPONENTS=smooth -DHSP_TOOL=ON >"$work/log" 2>&1; then
  echo "a program without the components that it calls is not refused" && exit 1
fi
