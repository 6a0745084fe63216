#!/usr/bin/env bash
# The core as one file, as .ci/one_file.py makes it: compiles alone and without a warning, has the stable functions and no other
# global symbol, needs nothing but some functions of C, and gives the bits of capi/abi/numerics.txt. A C program finds
# README's number with it.
#   one_file.sh SOURCE-FOLDER WORK-FOLDER C-COMPILER CXX-COMPILER [all]
# `all`: with g++ and clang, levels of optimization, -march=haswell, the second compile for AVX2, on 32 bits and on Arm.
# Exit status 77: there is no Python here, or the machine is big-endian.
set -euo pipefail
source=$1 work=$2 cc=$3 cxx=$4 all=${5:-}
export LC_ALL=C
command -v python3 >/dev/null || { echo "skipped: there is no python3 here" && exit 77; }
[ "$(printf '\1' | od -An -tx2 | tr -d ' ')" = 0001 ] || { echo "skipped: big-endian" && exit 77; }
rm -rf "$work"
mkdir -p "$work"
cd "$work"
python3 "$source/.ci/one_file.py" one
warnings=(-Wall -Wextra -Wpedantic -Werror)
awk '$1 != "#" && $3 == "stable" { print $1 }' "$source/capi/abi/since.txt" | sort >stable
sed -n '/^# Results of stable/,/^# Results of provisional/{/^#/!p}' "$source/capi/abi/numerics.txt" >bits
[ "$(wc -l <stable)" -gt 70 ] && [ "$(wc -l <bits)" -gt 100 ]

check_symbols() { # object
  nm -g --defined-only "$1" | awk '$2 != "V" && $3 !~ /^DW\.ref/ { print $3 }' | sort | diff stable - ||
    { echo "$1: < a stable function, > a global symbol" && exit 1; }
  # The last one is in the library of the compiler itself, which is always linked.
  nm -u "$1" | awk '{ print $2 }' | grep -vxE 'mem(cpy|move|set|cmp)|sqrt|__popcountdi2|_GLOBAL_OFFSET_TABLE_' >needs || return 0
  echo "$1 needs $(xargs <needs)" && exit 1
}
record() { # compiler of C++, its options: the program that prints the bits, all but the one file
  "$1" -std=c++20 -O1 -ffp-contract=off -Ione -I"$source/tests/support" "${@:2}" \
    -DHSP_OWN_MOLECULES="\"$source/bench/molecules\"" -DHSP_FURTHER_MOLECULES='""' -c \
    "$source/tests/packaging/numerics_record.cpp" "$source/tests/support/owned_handle.cpp" \
    "$source/tests/support/molecule_file.cpp"
}
check_bits() { # what it is, compiler, runner or "", options of the link
  "$2" "${@:4}" numerics_record.o owned_handle.o molecule_file.o ./hardsphere*.o -o record
  $3 ./record | sed -n 's/^stable //p' | diff -q bits - >/dev/null || { echo "$1: other bits" && exit 1; }
  echo "$1: $(wc -l <bits) results, the same bits"
}
compile() { # compiler, options
  rm -f hardsphere*.o
  "$1" -std=c++20 "${warnings[@]}" "${@:2}" -c one/hardsphere.cpp
}

compile "$cxx" -O2 -fno-exceptions
check_symbols hardsphere.o
record "$cxx"
check_bits "$cxx -O2" "$cxx" ""
cat >areas.c <<'C'
#include "hardsphere.h"
#include <stdio.h>
int main(void) {
  static char memory[HSP_AREAS_BYTES(2)];
  const double xyz[] = {0, 0, 0, 1, 0, 0}, radius[] = {1, 1};
  double area[2];
  size_t bytes = sizeof memory;
  hsp_totals totals;
  if (hsp_areas(2, xyz, radius, 0, memory, &bytes, &totals, area) != HSP_OK) return 1;
  printf("%.12f\n", totals.area);
  return 0;
}
C
"$cc" -std=c99 "${warnings[@]}" -Ione areas.c hardsphere.o -lm -o areas
[ "$(./areas)" = 18.849555921539 ] || { echo "two balls: $(./areas) instead of 6 pi" && exit 1; }
for option in -ffast-math -ffinite-math-only; do
  if "$cxx" -std=c++20 -O2 $option -c one/hardsphere.cpp -o fast.o 2>/dev/null; then echo "$option compiles" && exit 1; fi
done
[ "$all" = all ] || exit 0

for compiler in g++ clang++; do
  command -v "$compiler" >/dev/null || { echo "$compiler: skipped" && continue; }
  record "$compiler"
  for options in -O0 "-O2 -march=haswell" -O3 "-O3 -march=haswell"; do
    if [[ $options == *haswell* ]] && ! grep -qw avx2 /proc/cpuinfo; then continue; fi
    # shellcheck disable=SC2086 # the words of it are options
    compile "$compiler" $options
    check_bits "$compiler $options" "$compiler" ""
  done
  if [ "$compiler" = clang++ ]; then
    compile clang++ -O2 -funsafe-math-optimizations
    check_bits "clang++ -funsafe-math-optimizations" clang++ ""
  fi
  compile "$compiler" -O2 -fno-exceptions -DHSP_AVX2=1
  "$compiler" -std=c++20 "${warnings[@]}" -O2 -fno-exceptions -DHSP_TARGET=avx2 -mavx2 -mfma -mpopcnt -c one/hardsphere.cpp \
    -o hardsphere_avx2.o
  # Symbols that join both are hidden. No function is in both: those for AVX2 are not taken for others.
  readelf -sW hardsphere.o hardsphere_avx2.o | awk '($5 == "GLOBAL" || $5 == "WEAK") && $6 == "DEFAULT" && $7 ~ /^[0-9]/ { print $8 }' |
    (! grep -v '^DW\.ref') || { echo "$compiler: visible symbols" && exit 1; }
  nm -g --defined-only hardsphere.o hardsphere_avx2.o | awk 'NF == 3 && $3 !~ /^DW/ { print $3 }' | sort | uniq -d >both
  if grep . both; then echo "$compiler: in both objects" && exit 1; fi
  check_bits "$compiler with AVX2" "$compiler" ""
done
for target in "g++ -m32 -msse2 -mfpmath=sse" "aarch64-linux-gnu-g++" "arm-linux-gnueabihf-g++"; do
  read -ra words <<<"$target"
  runner=""
  if [[ $target == aarch64* ]]; then runner="qemu-aarch64-static -L /usr/aarch64-linux-gnu"; fi
  if [[ $target == arm-* ]]; then runner="qemu-arm-static -L /usr/arm-linux-gnueabihf"; fi
  if ! echo '#include <vector>' | "${words[@]}" -x c++ -c - -o probe.o 2>/dev/null ||
    { [ -n "$runner" ] && ! command -v "${runner%% *}" >/dev/null; }; then
    echo "$target: skipped"
    continue
  fi
  record "${words[@]}"
  compile "${words[@]}" -O2
  check_bits "$target" "${words[0]}" "$runner" "${words[@]:1}" -static
done
