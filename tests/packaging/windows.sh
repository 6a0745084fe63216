#!/usr/bin/env bash
# Library and program compile for Windows: the library as an archive, with which a program in C links; and as a DLL, which
# exports the functions of the headers and nothing else, with the program that loads it. Where Wine is there both run,
# and the program tells README's figures of crambin and writes a picture.
#   windows.sh SOURCE-FOLDER WORK-FOLDER
# Exit status 77: there is no MinGW here.
set -euo pipefail
source=$(realpath "$1") work=$2
command -v x86_64-w64-mingw32-g++-posix >/dev/null || { echo "skipped: there is no MinGW here; package g++-mingw-w64-x86-64" && exit 77; }
rm -rf "$work"
mkdir -p "$work"
cd "$work"
build() { # folder, whether a DLL is made, targets
  local folder=$1 shared=$2
  shift 2
  # Compiled in half the time: what is looked for does not depend on it.
  cmake -S "$source" -B "$folder" -DCMAKE_TOOLCHAIN_FILE="$source/tests/packaging/windows/mingw.cmake" \
    -DBUILD_SHARED_LIBS="$shared" -DCMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG" \
    "-DCMAKE_C_FLAGS_RELEASE=-O1 -DNDEBUG" -DHSP_TESTS=OFF -DHSP_BENCH=OFF -DHSP_FUZZ=OFF -DHSP_FORTRAN=OFF &&
    cmake --build "$folder" --target "$@" --parallel 2
}
{
  build archive OFF hardsphere && build dll ON hardsphere hardsphere_tool
  # Without HSP_USE_SHARED, which it needs for neither.
  x86_64-w64-mingw32-gcc-posix -I "$source/include" "$source/tests/packaging/consumers/main.c" \
    "$(find archive -name libhardsphere.a)" -o archive/main.exe
  x86_64-w64-mingw32-gcc-posix -I "$source/include" "$source/tests/packaging/consumers/main.c" \
    "$(find dll -name libhardsphere.dll.a)" -o dll/main.exe
} >log 2>&1 || { tail -n 40 log && exit 1; }
dll=$(find dll -name '*hardsphere*.dll')
x86_64-w64-mingw32-objdump -p "$dll" | sed -nE 's/^\s+\[ *[0-9]+\] (\+base\[ *[0-9]+\] +[0-9a-f]+ )?([A-Za-z_]\w*)$/\2/p' | sort >exported
grep -ohE '\bhsp_[a-z0-9_]+\(' "$source/capi/abi/functions.txt" | tr -d '(' | grep -v '^hsp_task$' | sort -u >declared
diff declared exported || { echo "the DLL exports other functions" && exit 1; }
if x86_64-w64-mingw32-objdump -p "$dll" | grep -E 'DLL Name: lib(gcc|stdc|winpthread)'; then
  echo "the DLL needs a library of the compiler" && exit 1
fi
wine=$(command -v wine64 || echo /usr/lib/wine/wine64)
[ -x "$wine" ] || { echo "compiled, archive and DLL of $(wc -l <exported) functions; there is no Wine here to run them" && exit; }
export WINEPREFIX=$PWD/prefix WINEDEBUG=-all
program=$(find dll -name hardsphere.exe)
# Windows looks for it beside the program.
for folder in dll "$(dirname "$program")"; do
  [ "$folder" -ef "$(dirname "$dll")" ] || cp "$dll" "$folder"
done
cp "$source/bench/molecules/crambin.pdb" .
for kind in archive dll; do
  "$wine" $kind/main.exe >drawn 2>errors || { cat drawn errors && echo "$kind: a program does not run" && exit 1; }
done
"$wine" "$program" measure crambin.pdb --probe 1.4 >figures 2>errors || { cat figures errors && exit 1; }
for figure in 'area +2971\.32301599' 'volume +8357\.3215455'; do
  grep -qE "$figure" figures || { cat figures && echo "not found: $figure" && exit 1; }
done
"$wine" "$program" draw crambin.pdb -o crambin.svg >drawn 2>errors || { cat drawn errors && exit 1; }
cmp crambin.svg "$source/tests/program/pictures/crambin.svg" 2>/dev/null || grep -q '</svg>' crambin.svg ||
  { echo "no picture" && exit 1; }
if grep -q $'\r' crambin.svg; then echo "the picture has other ends of lines" && exit 1; fi
echo "compiled, archive and DLL of $(wc -l <exported) functions, and run by Wine"
