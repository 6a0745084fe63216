#!/usr/bin/env bash
# The archive keeps its promises about symbols however it is compiled: without optimisation, where inlining hides
# nothing, and with the assertions that distributions switch on in the standard library. Code for wide registers does
# not leave its files.
#   archive_variants.sh SOURCE-FOLDER WORK-FOLDER C++-COMPILER
set -euo pipefail
source=$1 work=$2 cxx=$3
here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$work"
for flags in "-O0" "-O2 -D_GLIBCXX_ASSERTIONS" "-O0 -D_GLIBCXX_ASSERTIONS -DHSP_PORTABLE_LIMBS=1"; do
  echo "flags: $flags"
  build="$work/${flags//[^A-Za-z0-9]/_}"
  cmake -S "$source" -B "$build" -DCMAKE_CXX_COMPILER="$cxx" -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS="$flags" \
    -DHSP_TOOL=OFF -DHSP_TESTS=OFF -DHSP_BENCH=OFF -DHSP_FUZZ=OFF -DHSP_FORTRAN=OFF >/dev/null
  cmake --build "$build" --target hardsphere --parallel 2 >/dev/null
  bash "$here/archive_symbols.sh" "$build/libhardsphere.a" "$source/include/hardsphere.h"
  bash "$here/wide_symbols.sh" "$build/CMakeFiles/hardsphere_objects.dir/lib"
done
rm -rf "$work"
