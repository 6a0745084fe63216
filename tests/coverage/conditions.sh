#!/usr/bin/env bash
# Holds the core to MC/DC (modified condition/decision coverage): for each condition the tests must have two runs in
# which it is true and false, all other conditions of its decision are the same, and the decision differs. The tests are
# the unit tests, those of the interface, the laws and the differential ones. conditions.txt lists the exceptions, with
# a reason for each. Measured by clang 19, for the core alone, in one configuration.
#   conditions.sh SOURCE-FOLDER WORK-FOLDER
set -euo pipefail
source=$1 build=$2
for tool in clang++-19 llvm-profdata-19 llvm-cov-19; do
  command -v $tool >/dev/null || { echo "no $tool" && exit 77; }
done
mapfile -t files <"$source/lib/core_files.txt"
# All objects are compiled anew, as the compiler's warnings are looked at below.
rm -rf "$build"
mkdir -p "$build"
{ printf '[clang]\ndefault:skip\n' && printf 'source:*/%s=allow\n' "${files[@]}"; } >"$build/core.list"
quick=(-DCMAKE_{C,CXX}_FLAGS_RELEASE="-O1 -DNDEBUG")
count="-fprofile-instr-generate -fcoverage-mapping -fcoverage-mcdc -fprofile-list=$build/core.list"
export LLVM_PROFILE_FILE=$build/%m.profraw
# Without objcopy the archive has several objects: in one merged object the counters would be local symbols.
cmake -S "$source" -B "$build" -DCMAKE_BUILD_TYPE=Release -DCMAKE_C_COMPILER=clang-19 -DCMAKE_CXX_COMPILER=clang++-19 \
  "${quick[@]}" -DCMAKE_CXX_FLAGS="$count" -DCMAKE_EXE_LINKER_FLAGS=-fprofile-instr-generate -DCMAKE_OBJCOPY= \
  -DHSP_COMPONENTS= -DHSP_TESTS=ON -DHSP_SLOW_TESTS=OFF -DHSP_PRECOMPILED_GTEST=ON \
  -DHSP_{TOOL,FUZZ,BENCH,FORTRAN,INSTALL}=OFF >"$build/log"
cmake --build "$build" --parallel "${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}" >>"$build/log" 2>&1 ||
  { tail -n 40 "$build/log" && exit 1; }
! grep 'will not be covered' "$build/log" || exit 1
rm -f "$build"/*.profraw
ctest --test-dir "$build" -L core -LE 'slow|text' --parallel "${CTEST_PARALLEL_LEVEL:-$(nproc)}" --output-on-failure \
  >"$build/tests.log" || { tail -n 60 "$build/tests.log" && exit 1; }
mapfile -t programs < <(find "$build/tests" -name '*_tests' -type f -executable | sort)
llvm-profdata-19 merge -sparse "$build"/*.profraw -o "$build/profile"
llvm-cov-19 show --show-mcdc --dump -instr-profile="$build/profile" "${programs[@]/#/-object=}" \
  >"$build/shown.txt" 2>"$build/shown.log"
# The hash 0 stands for a function that a program has no code of; any other mismatch is an error.
! grep 'hash-mismatch' "$build/shown.log" | grep -v 'hash = 0x0$' || exit 1
cd "$source"
python3 tests/coverage/conditions.py "$build/shown.txt" tests/coverage/conditions.txt "${files[@]}"
