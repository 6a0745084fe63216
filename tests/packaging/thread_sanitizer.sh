#!/usr/bin/env bash
# No call races with another: the tests with executors, of hardsphere.hpp's threads and of handles in several threads, and
# the program's --threads, by clang's thread sanitizer. Loops of tests have a thread for each task there, which start
# together (tests/api/support/loops.c).
#   thread_sanitizer.sh SOURCE-FOLDER WORK-FOLDER core|whole
# core: the library without components, and its tests with executors.
# The work folder stays, so that a change costs what it touches.
set -euo pipefail
source=$1 work=$2 part=$3
molecule=$source/bench/molecules/crambin.pdb
export TSAN_OPTIONS=halt_on_error=1:exitcode=66
mkdir -p "$work"
run() { # command
  "$@" >"$work/log" 2>&1 || { tail -n 60 "$work/log" && exit 1; }
}
command -v clang++ >/dev/null || { echo "no clang++" && exit 77; }
echo 'int main() {}' >"$work/probe.cpp"
clang++ -fsanitize=thread "$work/probe.cpp" -o "$work/probe" 2>/dev/null || { echo "no thread sanitizer" && exit 77; }
# Without checked indices: what they count is no thread's own.
targets=(api_boundary_tests api_gradient_tests)
tests='api_boundary_executor|api_gradient_(executor|rows)'
count=3
options=(-DHSP_COMPONENTS= -DHSP_TOOL=OFF)
if [ "$part" = whole ]; then
  targets+=(api_surface_tests api_periodic_tests api_whole_handle_threads api_whole_workspace_cxx20 program_tests
    hardsphere_tool)
  tests+='|api_boxes_(gradient_shared|periodic_areas)|api_smooth_surface_gradient|api_whole_(handle_threads|workspace_cxx20)'
  tests+='|program_threads'
  count=9
  options=()
fi
run cmake -S "$source" -B "$work/build" -G Ninja -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ \
  -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_C_FLAGS_RELWITHDEBINFO="-O1 -gline-tables-only -DNDEBUG" \
  -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O1 -gline-tables-only -DNDEBUG" -DHSP_SANITIZE=thread -DHSP_TESTS=ON \
  -DHSP_ALL_TESTS=ON -DHSP_PRECOMPILED_GTEST=ON -DHSP_SLOW_TESTS=OFF -DHSP_BENCH=OFF -DHSP_FUZZ=OFF -DHSP_FORTRAN=OFF \
  -DHSP_INSTALL=OFF \
  "${options[@]}"
run cmake --build "$work/build" --parallel "${CMAKE_BUILD_PARALLEL_LEVEL:-2}" --target "${targets[@]}"
ctest --test-dir "$work/build" -R "^($tests)\$" --no-tests=error --output-on-failure | tee "$work/tests"
[ "$(grep -c ' Passed ' "$work/tests")" -eq $count ] || { echo "not all of $count tests ran" && exit 1; }
[ "$part" = whole ] || exit 0

# Of one file, of several, and of frames.
cp "$molecule" "$work/other.pdb"
for ((k = 1; k <= 12; ++k)); do
  echo "MODEL $k"
  grep '^ATOM' "$molecule"
  echo ENDMDL
done >"$work/frames.pdb"
program=$work/build/capi/hardsphere
for arguments in "measure $molecule" "measure $molecule $work/other.pdb" \
  "measure $molecule --trajectory $work/frames.pdb" "measure $molecule --trajectory $work/frames.pdb --mean"; do
  # shellcheck disable=SC2086 # several arguments
  for threads in 1 2 8; do
    "$program" $arguments --threads $threads >"$work/by_$threads" 2>"$work/errors" || { cat "$work/errors" && exit 1; }
    cmp "$work/by_1" "$work/by_$threads"
  done
done
