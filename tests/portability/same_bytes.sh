#!/usr/bin/env bash
# Builds the library and its programs with one compiler for one target, runs them there, and compares every byte of what
# they print with the reference outputs, which outputs.sh has written for the native build.
#   same_bytes.sh SOURCE-FOLDER WORK-FOLDER REFERENCE-FOLDER WHAT PACKAGE C-COMPILER C++-COMPILER EMULATOR CPU-FEATURES
#                 [CMAKE-OPTION...]
# WHAT: `few` outputs (see outputs.sh), all `outputs`, or with the C99 tests of the interface `all`. EMULATOR runs the
# target's programs on this machine, and may be empty. CPU-FEATURES are words of /proc/cpuinfo that this machine has to have. Exit status 77:
# something is missing here.
set -euo pipefail
source=$1 work=$2 reference=$3 what=$4 package=$5 c_compiler=$6 cxx_compiler=$7 emulator=$8 features=$9
shift 9
here=$(cd "$(dirname "$0")" && pwd)

skip() {
  echo "skipped: $*"
  exit 77
}

for compiler in "$c_compiler" "$cxx_compiler"; do
  command -v "$compiler" >/dev/null || skip "there is no $compiler here; package $package"
done
if [ -n "$emulator" ] && ! command -v "$emulator" >/dev/null; then
  skip "there is no $emulator here; package qemu-user"
fi
for feature in $features; do
  grep -qw "$feature" /proc/cpuinfo 2>/dev/null || skip "this processor lacks $feature"
done

rm -rf "$work"
mkdir -p "$work"
build() {
  "$@" >>"$work/log" 2>&1 || { tail -n 40 "$work/log" && exit 1; }
}
options=(-DCMAKE_C_COMPILER="$c_compiler" -DCMAKE_CXX_COMPILER="$cxx_compiler" -DCMAKE_BUILD_TYPE=Release -DHSP_WERROR=ON
  -DHSP_UNITY_BUILD=ON)
if [ -n "$emulator" ]; then
  # Linked statically, so that the emulator needs none of the target's shared libraries.
  options+=(-DCMAKE_SYSTEM_NAME=Linux -DCMAKE_EXE_LINKER_FLAGS=-static -DCMAKE_CROSSCOMPILING_EMULATOR="$emulator")
fi
build cmake -S "$here/target" -B "$work/build" "${options[@]}" "$@"
names='' target=outputs
case $what in
  few) names=few ;;
  all) target=all ;;
esac
build cmake --build "$work/build" --target $target --parallel 2

failed=0
unoptimized=$(grep -ow -- -O0 <<<"$*" || true)
HSP_UNOPTIMIZED=$unoptimized bash "$here/../packaging/archive_symbols.sh" "$work/build/hardsphere/libhardsphere.a" "$source" || failed=1
bash "$here/../packaging/target_symbols.sh" "$work/build/hardsphere/CMakeFiles/hardsphere_objects.dir" || failed=1

programs=$work/build
bash "$here/outputs.sh" "$source" "$work/outputs" "$emulator" "$programs/hardsphere/capi/hardsphere" \
  "$programs/interface_bits" "$programs/arc_tangent_bits" "$names"
[ -n "$names" ] || diff <(ls "$reference") <(ls "$work/outputs") || failed=1
differing=0
for other in "$work/outputs"/*; do
  output=$reference/${other##*/}
  cmp "$output" "$other" && continue
  differing=$((differing + 1))
  if [ $differing -le 5 ]; then diff "$output" "$other" | cut -c 1-400 | head -n 4 || true; fi
done
if [ $differing -gt 0 ]; then
  echo "$differing outputs differ from those of the native build"
  failed=1
fi

# The arc tangent as it must not be compiled, where the target has the instructions: that has to show.
fused=$programs/arc_tangent_bits_fused
if [ -e "$fused" ]; then
  # shellcheck disable=SC2086 # no emulator is no word
  $emulator "$fused" >"$work/fused"
  if sed '$d' "$reference/arc_tangent_bits" | cmp -s - "$work/fused"; then # all but the exit status
    echo "contracting products and sums made no difference: this comparison would notice nothing"
    failed=1
  fi
fi

if [ $target = all ]; then
  ctest --test-dir "$work/build" --parallel 2 --exclude-regex no_allocation --output-on-failure >"$work/tests" || {
    cat "$work/tests"
    failed=1
  }
  grep -E '^[0-9]+% tests passed' "$work/tests"
fi

[ $failed -eq 0 ] || exit 1
rm -rf "$work"
