#!/usr/bin/env bash
# Builds library and program for WebAssembly with Debian's clang and wasi-libc, runs them under Node, and compares every
# byte of what they print with the reference outputs, which outputs.sh has written for the native build.
#   wasm.sh SOURCE-FOLDER WORK-FOLDER REFERENCE-FOLDER
# The page is left in WORK-FOLDER for another test. Exit status 77: something is missing here.
set -euo pipefail
source=$1 work=$2 reference=$3
here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$work"
skip() {
  echo "skipped: $*"
  exit 77
}
for program in clang++-14 wasm-ld-14 llvm-ar-14 node; do
  command -v $program >/dev/null || skip "there is no $program here"
done
for file in /usr/lib/wasm32-wasi/libc.a /usr/lib/wasm32-wasi/libc++.a; do
  [ -e $file ] || skip "there is no $file; packages wasi-libc, libc++-14-dev-wasm32"
done
[ -e "$(clang-14 --target=wasm32-wasi -print-libgcc-file-name)" ] || skip "there is no libclang-rt-14-dev-wasm32"

build() {
  "$@" >>"$work/log" 2>&1 || { tail -n 40 "$work/log" && exit 1; }
}
mkdir -p "$work"
build cmake -S "$here/target" -B "$work/build" -DCMAKE_TOOLCHAIN_FILE="$source/capi/wasm/wasi.cmake" \
  -DCMAKE_BUILD_TYPE=Release -DHSP_WERROR=ON
build cmake --build "$work/build" --target outputs hardsphere_page --parallel 2

# The archive asks for memory copies, arithmetic of 128 bits and the stack, and for nothing else.
archive=$work/build/hardsphere/libhardsphere.a
llvm-nm-14 "$archive" >"$work/symbols"
asked=$(awk '$1 == "U" {print $2}' "$work/symbols" | sort -u)
offered=$(awk 'NF == 3 {print $3}' "$work/symbols" | sort -u)
refused=$(comm -23 <(echo "$asked") <(echo "$offered") | grep -vE '^(mem(cpy|move|set)|__(mul|ashl|ashr|lshr|udiv|umod|div|mod)ti3|__stack_pointer|__memory_base|__indirect_function_table)$' || true)
grep -q find_balls_in_lanes "$work/symbols" || { echo "the archive has no kernels of lanes" && exit 1; }
[ -z "$refused" ] || { echo "the archive asks for symbols that are not allowed:" && echo "$refused" && exit 1; }

# The same library where an engine has no registers of several numbers.
build cmake -S "$here/target" -B "$work/scalar" -DCMAKE_TOOLCHAIN_FILE="$source/capi/wasm/wasi.cmake" \
  -DCMAKE_BUILD_TYPE=Release -DHSP_WERROR=ON -DCMAKE_C_FLAGS= -DCMAKE_CXX_FLAGS=
build cmake --build "$work/scalar" --target interface_bits --parallel 2
llvm-nm-14 "$work/scalar/hardsphere/libhardsphere.a" >"$work/symbols"
if grep -q find_balls_in_lanes "$work/symbols"; then echo "an archive without lanes has kernels of them" && exit 1; fi
bash "$here/outputs.sh" "$source" "$work/scalar_outputs" "node --no-warnings $source/capi/wasm/run.mjs" \
  "" "$work/scalar/interface_bits.wasm" "" '^interface_bits$'
cmp "$reference/interface_bits" "$work/scalar_outputs/interface_bits" || exit 1
rm -rf "$work/scalar" "$work/scalar_outputs"

programs=$work/build
bash "$here/outputs.sh" "$source" "$work/outputs" "node --no-warnings $source/capi/wasm/run.mjs" \
  "$programs/hardsphere/capi/hardsphere.wasm" "$programs/interface_bits.wasm" "$programs/arc_tangent_bits.wasm"
failed=0
for output in "$work/outputs"/*; do
  cmp "$reference/${output##*/}" "$output" && continue
  diff "$reference/${output##*/}" "$output" | cut -c 1-400 | head -n 4 || true
  failed=$((failed + 1))
done
if ! diff <(ls "$reference") <(ls "$work/outputs"); then failed=$((failed + 1)); fi
[ $failed -eq 0 ] || { echo "$failed outputs differ from those of the native build" && exit 1; }
mv "$programs/hardsphere/capi/hardsphere.html" "$work"
rm -rf "$work/build" "$work/outputs"
