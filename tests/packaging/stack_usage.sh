#!/usr/bin/env bash
# The most stack that each entry point can take, from the compiler's own call graph and frame sizes. Fails on recursion,
# on frames whose size is known at run time only, on calls through pointers but those of known types, and beyond the limit.
#   stack_usage.sh SOURCE-FOLDER WORK-FOLDER G++ LIMIT-IN-BYTES [OBJECT-FOLDER]
# g++ alone writes the call graph (-fcallgraph-info=su). OBJECT-FOLDER: where a build has left it beside its objects; else
# all is compiled here. What memcpy, memset, sqrt and a caller's sink take is not counted.
set -euo pipefail
export LC_ALL=C
source=$1 work=$2 cxx=$3 limit=$4 objects=${5:-}
here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$work"
mkdir -p "$work"
cd "$work"
mapfile -t files < <(cd "$source" && find lib capi -maxdepth 2 -name '*.cpp' | sort)
if [ -z "$objects" ]; then
  objects=$work
  mkdir -p "${files[@]%/*}"
  # Code for wide registers is looked at too, where the compiler makes it.
  wide=
  if [ "$("$cxx" -dumpmachine | cut -d- -f1)" = x86_64 ]; then wide=-DHSP_AVX2=1; fi
  for file in "${files[@]}"; do
    echo "$objects/$file.o $source/$file$([ -z "$wide" ] || sed -n 's/.*_avx2\.cpp$/ -mavx2 -mfma -mpopcnt/p' <<<"$file")"
  done | xargs -P 2 -L 1 "$cxx" $wide -std=c++20 -O2 -I"$source/include" -I"$source/lib" -I"$source/capi" -ffp-contract=off \
    -fno-math-errno -fno-exceptions -fno-rtti -fno-threadsafe-statics -fcallgraph-info=su -fstack-usage -c -o
fi
bash "$here/header_functions.sh" "$source/include/hardsphere.h" >entries
# The graphs of the sources that there are: the folder may hold some of files that are gone.
cd "$objects"
awk -v limit="$limit" -f "$here/stack_usage.awk" "$work/entries" "${files[@]/%/.ci}"
