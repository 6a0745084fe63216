#!/usr/bin/env bash
# Which lines of the library the tests run:
#   bash tests/coverage/run.sh
# Builds and runs the workflow preset `coverage` (g++, no optimisation, all tests but the slow ones and those that look
# at what is shipped), prints the lines run of lib/ and capi/shims/*.cpp and fails if they are fewer than 95 of 100. The
# program's lines are printed as well but decide nothing. Installs gcovr if it is missing (Debian).
# Lines marked GCOVR_EXCL_LINE do not count; each says why no input reaches it.
set -euo pipefail
cd "$(dirname "$0")/../.."
least=95

fail() {
  echo "coverage/run.sh: $*" >&2
  exit 1
}

# shellcheck source=.ci/install.sh
. .ci/install.sh
install_packages "${packages_for_tests[@]}" gcovr

build=build/coverage
cmake --preset coverage >/dev/null
cmake --build --preset coverage --parallel "${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}" | tail -n 1
# Without this the counts of an earlier run would be added.
find "$build" -name '*.gcda' -delete
ctest --preset coverage --parallel "${CTEST_PARALLEL_LEVEL:-$(nproc)}"

# The folders have the objects of the library, of the program, and of the tests, which compile parts of the library's
# headers. stage_counters.hpp is left out: it is no part of the library as it ships, and one of its functions has two
# bodies, which gcovr 5.2 cannot merge.
covered() {
  gcovr --root . --exclude 'lib/ground/exact/stage_counters\.hpp' --print-summary "$@" \
    "$build/CMakeFiles" "$build/capi" "$build/tests" "$build/fuzz"
}
rm -rf "$build"/CMakeFiles/[0-9]*/CompilerId*
echo "== the program"
covered --filter 'capi/program/'
echo "== the library"
covered --filter 'lib/' --filter 'capi/shims/' --fail-under-line "$least" ||
  fail "fewer than $least % of the library's lines were run"
