#!/usr/bin/env bash
# The whole test program for another processor in an emulator: unit tests of all rooms, the interface against oracles,
# its C99 tests, fuzz inputs. GoogleTest is compiled for it from the sources that Debian has (package googletest).
#   whole_tests.sh SOURCE-FOLDER WORK-FOLDER TOOLS EMULATOR [FLAGS]
# TOOLS: what the compilers' names begin with. Exit status 77: something is missing here.
set -euo pipefail
source=$1 work=$2 tools=$3 emulator=$4 flags=${5:-}
skip() {
  echo "skipped: $*"
  exit 77
}
command -v "$tools-g++" >/dev/null || skip "there is no $tools-g++ here; package g++-$tools"
if [ -n "$emulator" ] && ! command -v "$emulator" >/dev/null; then
  skip "there is no $emulator here; package qemu-user"
fi
googletest=/usr/src/googletest
[ -e $googletest/CMakeLists.txt ] || skip "there are no sources of GoogleTest here; package googletest"
# Not with further molecules, of up to 165,000 balls: they would take half of the time.
unset HSP_MOLECULES
rm -rf "$work"
mkdir -p "$work"
build() {
  "$@" >>"$work/log" 2>&1 || { tail -n 40 "$work/log" && exit 1; }
}
# Linked statically, so that the emulator needs none of the target's shared libraries. The vectorizer of GCC 12 for
# aarch64 breaks off at a loop of a C99 test (vect_transform_reduction); the library is compiled without it anyway.
target=(-DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR="${tools%%-*}" -DCMAKE_C_COMPILER="$tools-gcc"
  -DCMAKE_CXX_COMPILER="$tools-g++" -DCMAKE_C_FLAGS="$flags -fno-tree-vectorize" -DCMAKE_CXX_FLAGS="$flags"
  -DCMAKE_BUILD_TYPE=Release
  -DCMAKE_EXE_LINKER_FLAGS=-static -DCMAKE_CROSSCOMPILING_EMULATOR="$emulator")
build cmake -S $googletest -B "$work/googletest" "${target[@]}" -DBUILD_GMOCK=OFF -DCMAKE_INSTALL_PREFIX="$work/prefix"
build cmake --build "$work/googletest" --target install --parallel 2
build cmake -S "$source" -B "$work/build" "${target[@]}" -DCMAKE_PREFIX_PATH="$work/prefix" \
  -DHSP_TESTS=ON -DHSP_FUZZ=ON -DHSP_TOOL=OFF -DHSP_BENCH=OFF -DHSP_FORTRAN=OFF -DHSP_INSTALL=OFF -DHSP_SLOW_TESTS=OFF \
  -DHSP_ALL_TESTS=ON -DHSP_CHECKED_LIBRARY=ON -DHSP_PRECOMPILED_GTEST=ON -DHSP_WERROR=OFF
build cmake --build "$work/build" --parallel 2
ctest --test-dir "$work/build" --parallel 2 --output-on-failure >"$work/tests" || {
  tail -n 200 "$work/tests"
  exit 1
}
grep -E '^[0-9]+% tests passed' "$work/tests"
rm -rf "$work/build" "$work/googletest"
