#!/usr/bin/env bash
# The compiler holds the order of the parts of lib: with the flags that a source of a part is compiled with, the headers of
# those that it stands on are found, and no others. (include_direction.sh holds that of the rooms within a part.)
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

# For each part and for the interface a line that is there if one of its headers is found.
for part in ground balls union curvature motion bricks boxes wide smooth space sight interface; do
  case $part in
    interface) header=hardsphere.h ;;
    *) header=$(cd "$source/lib/$part" && ls */*.hpp | head -n 1) ;;
  esac
  printf '#if __has_include("%s")\n%s\n#endif\n' "$header" "$part"
done >"$work/headers.cpp"

failed=0 n=0
check() { # pattern of files, the parts whose headers they find, and `interface` if they find that
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
check "($(first curvature))" "ground balls union curvature"
check "($(first motion))" "ground balls union motion"
check "($(first bricks))" "ground balls union bricks"
check "($(first boxes))" "ground balls union curvature boxes"
check "($(first smooth))" "ground balls union wide smooth"
check "($(first space))" "ground balls union curvature boxes wide space"
check "($(first sight))" "ground balls union sight"
check "capi/shims/(core|residues)/[a-z_]+.cpp" "ground balls union interface"
check "capi/shims/curvature/[a-z_]+.cpp" "ground balls union curvature interface"
check "capi/shims/motion/[a-z_]+.cpp" "ground balls union motion interface"
check "capi/shims/bricks/[a-z_]+.cpp" "ground balls union bricks interface"
check "capi/shims/boxes/[a-z_]+.cpp" "ground balls union curvature boxes interface"
check "capi/shims/smooth/[a-z_]+.cpp" "ground balls union wide smooth interface"
check "capi/shims/space/[a-z_]+.cpp" "ground balls union curvature boxes wide space interface"
check "capi/shims/sight/[a-z_]+.cpp" "ground balls union sight interface"
rm -rf "$work"
[ $failed -eq 0 ] && echo "$n sources find the headers of the parts that they stand on, and no others"
exit $failed
