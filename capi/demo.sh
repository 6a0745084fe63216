#!/bin/bash
# Builds the program hardsphere and shows on crambin (PDB 1CRN, 327 atoms) and caffeine what it does.
# Runs from any folder; installs the Debian packages it misses; builds in build/demo and is quick when run again.
set -u
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd) || exit 1
build=$root/build/demo
crambin=bench/molecules/crambin.pdb
caffeine=bench/molecules/caffeine.pdb

fail() {
  echo "demo: $*" >&2
  exit 1
}

# shellcheck source=.ci/install.sh
. "$root/.ci/install.sh"
install_packages cmake ninja-build gcc g++ libc6-dev binutils || exit 1

mkdir -p "$build" || fail "cannot create $build"
log=$build/log.txt
# A build folder that was made for another checkout is of no use here.
if ! grep -qsxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$build/CMakeCache.txt"; then
  rm -rf "$build/CMakeCache.txt" "$build/CMakeFiles"
fi
echo "Building the library and the program in $build ..."
if ! { cmake -S "$root" -B "$build" -G Ninja -DCMAKE_C_COMPILER=gcc -DCMAKE_CXX_COMPILER=g++ \
         -DCMAKE_BUILD_TYPE=Release -DHSP_TOOL=ON -DHSP_TESTS=OFF -DHSP_BENCH=OFF -DHSP_FUZZ=OFF \
         -DHSP_FORTRAN=OFF &&
       cmake --build "$build"; } >"$log" 2>&1; then
  cat "$log" >&2
  fail "the build failed; see above"
fi
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
