#!/usr/bin/env bash
# The core reads no byte that nobody wrote: the tests of its functions in C99, by clang's memory sanitizer. The library needs no
# C++ run-time library, so all that runs is compiled for it but the C library, which the sanitizer knows. Without code for wide
# registers: lanes behind the last number hold anything and are masked, which the sanitizer takes for use.
#   memory_sanitizer.sh SOURCE-FOLDER WORK-FOLDER
# The work folder stays, so that a change costs what it touches.
set -euo pipefail
source=$1 work=$2
mkdir -p "$work"
run() { # command
  "$@" >"$work/log" 2>&1 || { tail -n 60 "$work/log" && exit 1; }
}
echo 'int main(void) { return 0; }' >"$work/probe.c"
clang -fsanitize=memory "$work/probe.c" -o "$work/probe" 2>/dev/null || { echo "no memory sanitizer" && exit 77; }
targets=()
for noun in header model query boundary gradient limits contacts topology; do targets+=("api_${noun}_tests"); done
run cmake -S "$source" -B "$work/build" -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ \
  -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_C_FLAGS_RELWITHDEBINFO="-O1 -gline-tables-only -DNDEBUG" \
  -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O1 -gline-tables-only -DNDEBUG" -DHSP_SANITIZE=memory -DHSP_TESTS=ON \
  -DHSP_SLOW_TESTS=OFF -DHSP_BENCH=OFF -DHSP_FUZZ=OFF -DHSP_FORTRAN=OFF -DHSP_INSTALL=OFF -DHSP_COMPONENTS= -DHSP_TOOL=OFF \
  -DHSP_WIDE_CODE=OFF
run cmake --build "$work/build" --parallel "${CMAKE_BUILD_PARALLEL_LEVEL:-2}" --target "${targets[@]}"
ctest --test-dir "$work/build" -R '^api_' -E '_slow$|cxx20$|^api_whole_' --no-tests=error --output-on-failure | tee "$work/tests"
[ "$(grep -c ' Passed ' "$work/tests")" -ge 20 ] || { echo "not all tests ran" && exit 1; }
