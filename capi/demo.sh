#!/bin/bash
# Builds the program hardsphere and shows on crambin (PDB 1CRN, 327 atoms) and caffeine what it does.
# Runs from any folder; installs the Debian packages it misses; builds in build/demo what it shows, without the
# components smooth, space and bricks, or takes the whole program, which tests/run.sh has built. Quick when run again.
set -u
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd) || exit 1
folder=$root/build/demo
crambin=bench/molecules/crambin.pdb
caffeine=bench/molecules/caffeine.pdb

fail() {
  echo "demo: $*" >&2
  exit 1
}

# shellcheck source=.ci/install.sh
. "$root/.ci/install.sh"
install_packages cmake ninja-build gcc g++ libc6-dev binutils || exit 1

mkdir -p "$folder" || fail "cannot create $folder"
log=$folder/log.txt
# A build folder that was made for another checkout is of no use here.
is_of_this_checkout() { grep -qsxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$1/CMakeCache.txt"; }
build=$root/build/dev
components="residues;curvature;motion;boxes;sight"
if ! { is_of_this_checkout "$build" && [ -x "$build/capi/hardsphere" ]; }; then
  build=$folder
  is_of_this_checkout "$build" || rm -rf "$build/CMakeCache.txt" "$build/CMakeFiles"
  cmake -S "$root" -B "$build" -G Ninja -DCMAKE_C_COMPILER=gcc -DCMAKE_CXX_COMPILER=g++ \
    -DCMAKE_BUILD_TYPE=Release -DHSP_TOOL=ON -DHSP_TESTS=OFF -DHSP_BENCH=OFF -DHSP_FUZZ=OFF \
    -DHSP_FORTRAN=OFF "-DHSP_COMPONENTS=$components" >"$log" 2>&1 || { cat "$log" >&2 && fail "CMake failed; see above"; }
fi
echo "Building the library and the program in $build ..."
cmake --build "$build" --target hardsphere_tool >"$log" 2>&1 || { cat "$log" >&2 && fail "the build failed; see above"; }
program=$build/capi/hardsphere

cd "$root" || exit 1
show() {
  printf '\n== %s\n\n$ hardsphere' "$1"
  shift
  printf ' %s' "$@"
  printf '\n'
  "$program" "$@" || fail "hardsphere $1 failed"
}

show "How well the balls behave: the crambin row of Section 2" model $crambin --radii chem3d
show "The boundary of the van der Waals surface, exactly" boundary $crambin
show "Its area and volume" measure $crambin
show "The same of the solvent-accessible surface, for a water probe" boundary $crambin --probe 1.4
show "Its area and volume" measure $crambin --probe 1.4
show "Which atoms touch a water molecule there" query $crambin --ball 10 10 10 1.4
show "The cavity in crambin: a water molecule fits there and cannot get out" voids $crambin --probe 1.4 --balls
show "How area and volume of caffeine change when an atom moves or grows" measure $caffeine --gradient
picture=build/demo/crambin.svg
show "Crambin as it looks, hidden parts removed" draw $crambin -o $picture --style soft
printf '\nThe picture is %s: every browser shows it.\n' "$root/$picture"
if [ "$build" = "$folder" ]; then
  printf '\nFree space, pores and smooth surfaces are not in this program. The whole: cmake -S %s -B %s\n  && %s\n' \
    "$root" build/whole "cmake --build build/whole --target hardsphere_tool --parallel"
fi
