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
if [ -z "$objects" ]; then
  # A unit for each room, for the interface and for the code for wide registers, where the compiler makes it.
  objects=$work
  (cd "$source" && find lib capi -maxdepth 3 -name '*.cpp' | sort) | while read -r file; do
    unit=$(basename "$(dirname "$file")")
    case $file in *_avx2.cpp) unit=avx2 ;; esac
    echo "#include \"$source/$file\"" >>"$unit.cpp"
  done
  wings=("$source"/lib/*/)
  wide=()
  if [ "$("$cxx" -dumpmachine | cut -d- -f1)" = x86_64 ]; then wide=(-DHSP_AVX2=1); fi
  for unit in *.cpp; do
    echo "$unit.o $unit$([ $unit != avx2.cpp ] || [ ${#wide[@]} -eq 0 ] || echo ' -mavx2 -mfma -mpopcnt')"
  done | xargs -P 2 -L 1 "$cxx" "${wide[@]}" -std=c++20 -O2 -I"$source/include" "${wings[@]/#/-I}" -I"$source/capi/shims" \
    -ffp-contract=off -fno-math-errno -fno-exceptions -fno-rtti -fno-threadsafe-statics -fcallgraph-info=su \
    -fstack-usage -c -o
fi
bash "$here/header_functions.sh" "$source" >entries
# A folder of units may hold graphs of single files, too, from before.
cd "$objects"
graphs=$(find . -path '*/Unity/*' -name '*.ci')
[ -n "$graphs" ] || graphs=$(find . -name '*.ci')
mapfile -t graphs <<<"$graphs"
awk -v limit="$limit" -f "$here/stack_usage.awk" "$work/entries" "${graphs[@]}"
