#!/usr/bin/env bash
# The compiler holds the order of the wings: with the flags that a source of a wing is compiled with, the headers of those
# that it stands on are found, and no others. (include_direction.sh holds that of the rooms within a wing.)
#   wings.sh SOURCE-FOLDER WORK-FOLDER C-COMPILER C++-COMPILER
set -euo pipefail
export LC_ALL=C
source=$(cd "$1" && pwd) work=$2 cc=$3 cxx=$4
rm -rf "$work"
mkdir -p "$work"
# Each source by its own command.
cmake -S "$source" -B "$work/build" -DCMAKE_C_COMPILER="$cc" -DCMAKE_CXX_COMPILER="$cxx" -DHSP_UNITY_BUILD=OFF \
  -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DHSP_TOOL=OFF -DHSP_TESTS=OFF -DHSP_BENCH=OFF -DHSP_FUZZ=OFF -DHSP_FORTRAN=OFF \
  >"$work/log" 2>&1 || { tail -n 40 "$work/log" && exit 1; }

# For each wing and for the interface a line that is there if one of its headers is found.
for wing in ground balls union smooth space sight interface; do
  case $wing in
    interface) header=hardsphere.h ;;
    *) header=$(cd "$source/lib/$wing" && ls */*.hpp | head -n 1) ;;
  esac
  printf '#if __has_include("%s")\n%s\n#endif\n' "$header" "$wing"
done >"$work/headers.cpp"

failed=0 n=0
check() { # pattern of files, the wings whose headers they find, and `interface` if they find that
  local files file flags found
  files=$(grep -oE "\"file\": \"$source/$1\"" "$work/build/compile_commands.json" | sed 's/.*: "//; s/"$//')
  [ -n "$files" ] || { echo "no file $1" && exit 1; }
  for file in $files; do
    read -ra flags <<<"$(grep -F -- "-c $file\"" "$work/build/compile_commands.json" | grep -oE -- '-I[^ ]+' | tr '\n' ' ')"
    n=$((n + 1))
    found=$("$cxx" -E -P "${flags[@]}" "$work/headers.cpp" | xargs)
    if [ "$found" != "$2" ]; then
      echo "${file#"$source"/} finds headers of: $found, instead of: $2"
      failed=1
    fi
  done
}
# Of each room one file, and all of the interface.
first() { (cd "$source" && for room in lib/"$1"/*/; do find "$room" -name '*.cpp' | sort | head -n 1; done | tr '\n' '|' | sed 's/|$//'); }
check "($(first ground))" "ground"
check "($(first balls))" "ground balls"
check "($(first union))" "ground balls union"
check "($(first smooth))" "ground balls union smooth"
check "($(first space))" "ground balls union space"
check "($(first sight))" "ground balls union sight"
check "capi/shims/hsp_(status|element|model|query|body).cpp" "ground balls interface"
check "capi/shims/hsp_(boundary|measure|topology|contacts|periodic|moving).cpp" "ground balls union interface"
check "capi/shims/hsp_(surface|mesh).cpp" "ground balls union smooth interface"
check "capi/shims/hsp_(cells|paths).cpp" "ground balls union space interface"
check "capi/shims/hsp_(view|map|sticks|picture).cpp" "ground balls union sight interface"
rm -rf "$work"
[ $failed -eq 0 ] && echo "$n sources find the headers of the wings that they stand on, and no others"
exit $failed
