#!/usr/bin/env bash
# The archive keeps its promises about symbols however it is compiled: without optimisation, where inlining hides
# nothing, and with the assertions that distributions switch on in the standard library. Code for wide registers does
# not leave its files.
#   archive_variants.sh VARIANT SOURCE-FOLDER WORK-FOLDER C++-COMPILER
# VARIANT: checked_O0, checked_O2 (with these assertions), limbs32_O0 (with them, and 32-bit limbs)
set -euo pipefail
variant=$1 source=$2 work=$3 cxx=$4
here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$work"
mkdir -p "$work"
flags="-${variant#*_} -D_GLIBCXX_ASSERTIONS"
if [ "${variant%_*}" = limbs32 ]; then flags+=" -DHSP_PORTABLE_LIMBS=1"; fi
echo "flags: $flags"
{
  cmake -S "$source" -B "$work/build" -DCMAKE_CXX_COMPILER="$cxx" -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS="$flags" \
    -DHSP_TOOL=OFF -DHSP_TESTS=OFF -DHSP_BENCH=OFF -DHSP_FUZZ=OFF -DHSP_FORTRAN=OFF &&
    cmake --build "$work/build" --target hardsphere --parallel 2
} >"$work/log" 2>&1 || { tail -n 40 "$work/log" && exit 1; }
bash "$here/archive_symbols.sh" "$work/build/libhardsphere.a" "$source/include/hardsphere.h"
bash "$here/wide_symbols.sh" "$work/build/CMakeFiles/hardsphere_objects.dir"
rm -rf "$work"
