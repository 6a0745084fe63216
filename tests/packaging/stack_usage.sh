#!/usr/bin/env bash
# The most stack that each entry point can take, from the compiler's own call graph and frame sizes. Fails on recursion,
# on frames whose size is known at run time only, on calls through pointers but those of known types, and beyond the limit.
#   stack_usage.sh SOURCE-FOLDER WORK-FOLDER G++ LIMIT-IN-BYTES
# g++ alone writes the call graph (-fcallgraph-info). What memcpy, memset, sqrt and a caller's sink take is not counted.
set -euo pipefail
export LC_ALL=C
source=$1 work=$2 cxx=$3 limit=$4
here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$work"
mkdir -p "$work"
cd "$work"
# Code for wide registers is looked at too, where the compiler makes it.
wide=
if [ "$("$cxx" -dumpmachine | cut -d- -f1)" = x86_64 ]; then wide=-DHSP_AVX2=1; fi
n=0
find "$source/lib" "$source/capi" -maxdepth 2 -name '*.cpp' | sort | while read -r file; do
  n=$((n + 1))
  echo "$n-$(basename "$file" .cpp).o $file"
done | if [ -n "$wide" ]; then sed '/_avx2\.cpp$/s/$/ -mavx2 -mfma -mpopcnt/'; else cat; fi | xargs -P 2 -L 1 "$cxx" $wide -std=c++20 -O2 -I"$source/include" -I"$source/lib" -I"$source/capi" -ffp-contract=off \
  -fno-math-errno -fno-exceptions -fno-rtti -fno-threadsafe-statics -fcallgraph-info=su -fstack-usage -c -o
bash "$here/header_functions.sh" "$source/include/hardsphere.h" >entries
awk -v limit="$limit" -f "$here/stack_usage.awk" entries ./*.ci
