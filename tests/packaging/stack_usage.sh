#!/usr/bin/env bash
# The most stack that each entry point can take, from the compiler's own call graph and frame sizes. Fails on recursion,
# on frames whose size is known at run time only, on calls through pointers but those of known types, and beyond the limit.
#   stack_usage.sh SOURCE-FOLDER WORK-FOLDER G++ LIMIT-IN-BYTES [OBJECT-FOLDER]
# g++ alone writes the call graph (-fcallgraph-info=su). OBJECT-FOLDER: where a build has left it beside its objects; else
# all is compiled here. The stack of memcpy, memset, sqrt and a caller's sink is not counted.
set -euo pipefail
export LC_ALL=C
source=$1 work=$2 cxx=$3 limit=$4 objects=${5:-}
here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$work"
mkdir -p "$work"
cd "$work"
if [ -z "$objects" ]; then
  # A unit for each room, for the interface and for the kernels of each further target.
  objects=$work
  lanes=$(sed -n '/^set(HSP_SOURCES_OF_LANES/,/)/p' "$source/lib/library.cmake")
  [ "$("$cxx" -dumpmachine | cut -d- -f1)" != x86_64 ] || lanes=
  (cd "$source" && find lib capi/shims -maxdepth 3 -name '*.cpp' | sort) | while read -r file; do
    [[ $lanes != *$file* ]] || continue
    case $file in
      *.kernel.cpp) units="$(basename "$(dirname "$file")") avx2" ;;
      *) units=$(basename "$(dirname "$file")") ;;
    esac
    for unit in $units; do echo "#include \"$source/$file\"" >>"$unit.cpp"; done
  done
  wings=("$source"/lib/*/ "$source"/capi/shims/*/)
  wide=(-DHSP_AVX2=1 -DHSP_LANES=1)
  [ "$("$cxx" -dumpmachine | cut -d- -f1)" = x86_64 ] || { wide=() && rm avx2.cpp; }
  for unit in *.cpp; do
    case $unit in
      avx2.cpp) echo "$unit.o $unit -DHSP_TARGET=avx2 -mavx2 -mfma -mpopcnt" ;;
      *) echo "$unit.o $unit -DHSP_TARGET=baseline" ;;
    esac
  done | xargs -P 2 -L 1 "$cxx" "${wide[@]}" -std=c++20 -O2 -I"$source/include" "${wings[@]/#/-I}" \
    -ffp-contract=off -DHSP_NO_CONTRACTION=1 -fno-math-errno -fno-exceptions -fno-rtti -fno-threadsafe-statics -fcallgraph-info=su \
    -fstack-usage -c -o
fi
bash "$here/header_functions.sh" "$source" >entries
# A folder of units may hold graphs of single files, too, from before.
cd "$objects"
graphs=$(find . -path '*/Unity/*' -name '*.ci')
[ -n "$graphs" ] || graphs=$(find . -name '*.ci')
mapfile -t graphs <<<"$graphs"
awk -v limit="$limit" -f "$here/stack_usage.awk" "$work/entries" "${graphs[@]}"
