#!/usr/bin/env bash
# Library and program compile for Windows, and where Wine is there the program tells README's
# figures of crambin and writes a picture.
#   windows.sh SOURCE-FOLDER WORK-FOLDER
# Exit status 77: there is no MinGW here.
set -euo pipefail
source=$(realpath "$1") work=$2
command -v x86_64-w64-mingw32-g++-posix >/dev/null || { echo "skipped: there is no MinGW here; package g++-mingw-w64-x86-64" && exit 77; }
rm -rf "$work"
mkdir -p "$work"
{
  # Compiled in half the time: what is looked for does not depend on it.
  cmake -S "$source" -B "$work/build" -DCMAKE_TOOLCHAIN_FILE="$source/tests/packaging/windows/mingw.cmake" \
    -DCMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG" "-DCMAKE_C_FLAGS_RELEASE=-O1 -DNDEBUG" \
    -DHSP_TESTS=OFF -DHSP_BENCH=OFF -DHSP_FUZZ=OFF -DHSP_FORTRAN=OFF &&
    cmake --build "$work/build" --target hardsphere hardsphere_tool --parallel 2
} >"$work/log" 2>&1 || { tail -n 40 "$work/log" && exit 1; }
wine=$(command -v wine64 || echo /usr/lib/wine/wine64)
[ -x "$wine" ] || { echo "compiled; there is no Wine here to run it" && exit; }
export WINEPREFIX=$work/prefix WINEDEBUG=-all
cd "$work"
cp "$source/bench/molecules/crambin.pdb" .
program=build/capi/hardsphere.exe
"$wine" $program measure crambin.pdb --probe 1.4 >figures 2>errors || { cat figures errors && exit 1; }
for figure in 'area +2971\.32301599' 'volume +8357\.3215455'; do
  grep -qE "$figure" figures || { cat figures && echo "not found: $figure" && exit 1; }
done
"$wine" $program draw crambin.pdb -o crambin.svg >drawn 2>errors || { cat drawn errors && exit 1; }
cmp crambin.svg "$source/tests/program/pictures/crambin.svg" 2>/dev/null || grep -q '</svg>' crambin.svg ||
  { echo "no picture" && exit 1; }
if grep -q $'\r' crambin.svg; then echo "the picture has other ends of lines" && exit 1; fi
echo "compiled, and run by Wine"
