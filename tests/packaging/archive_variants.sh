#!/usr/bin/env bash
# The archive keeps its promises about symbols however it is compiled: without optimisation, where inlining hides
# nothing, and with the assertions that distributions switch on in the standard library. Code for wide registers does
# not leave its files. Without optimisation and with 128-bit integers it is looked at by portability_gcc_O0.
#   archive_variants.sh FLAGS SOURCE-FOLDER WORK-FOLDER C++-COMPILER
set -euo pipefail
flags=$1 source=$2 work=$3 cxx=$4
here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$work"
echo "flags: $flags"
cmake -S "$source" -B "$work" -DCMAKE_CXX_COMPILER="$cxx" -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS="$flags" \
  -DHSP_TOOL=OFF -DHSP_TESTS=OFF -DHSP_BENCH=OFF -DHSP_FUZZ=OFF -DHSP_FORTRAN=OFF >/dev/null
cmake --build "$work" --target hardsphere --parallel 2 >/dev/null
bash "$here/archive_symbols.sh" "$work/libhardsphere.a" "$source/include/hardsphere.h"
bash "$here/wide_symbols.sh" "$work/CMakeFiles/hardsphere_objects.dir/lib"
rm -rf "$work"
