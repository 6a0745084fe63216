#!/bin/bash
# Runs every benchmark and writes build/bench/report/report.md, with the paper's figures beside ours.
# Usage: bash bench/run.sh [--quick] [--peers]
#   --quick  one repetition of each benchmark, as short as it gets: for trying out, not for quoting
#   --peers  time other programs by turns with the library: FreeSASA, CGAL, nanoflann, gemmi. What of them is missing
#            is installed from Debian's packages if it can be, and left out otherwise
# Missing packages are installed with apt-get (as root, or through sudo). The environment variable BENCH_BUILD names
# another folder to build in. Takes five to ten minutes, once the machine has come to rest after building.
set -euo pipefail

quick=no
peers=no
for argument in "$@"; do
  case "$argument" in
    --quick) quick=yes ;;
    --peers) peers=yes ;;
    *) sed -n '2,8s/^# //p' "$0" >&2; exit 2 ;;
  esac
done

source_folder=$(cd "$(dirname "$0")/.." && pwd)
build_folder=${BENCH_BUILD:-$source_folder/build/bench}
report_folder=$build_folder/report

# shellcheck source=.ci/install.sh
. "$source_folder/.ci/install.sh"
install_packages binutils cmake g++ libbenchmark-dev ninja-build
if [ "$peers" = yes ]; then install_optional_packages "${packages_of_peers[@]}"; fi

cmake -S "$source_folder" -B "$build_folder" -G Ninja -DCMAKE_BUILD_TYPE=Release -DHSP_BENCH=ON \
  -DHSP_TESTS=OFF -DHSP_TOOL=OFF -DHSP_FUZZ=OFF -DHSP_FORTRAN=OFF -DHSP_BENCH_PEERS=$peers
cmake --build "$build_folder"

# Building leaves a load average that takes a minute or two to fall. A benchmark by itself is a load of 1.
is_busy() {
  awk '{ exit !($1 > 1.5) }' /proc/loadavg
}
wait_for_rest() {
  local seconds
  for ((seconds = 0; seconds < 180; seconds += 5)); do
    if ! is_busy; then return; fi
    if [ "$seconds" -eq 0 ]; then printf 'Waiting up to three minutes for the load average to fall below 1.5.\n'; fi
    sleep 5
  done
  printf 'The machine stays busy (load average %s): the report says so, and its times are not for quoting.\n' \
    "$(cut -d ' ' -f 1 /proc/loadavg)"
}
if [ "$quick" = no ] && [ -r /proc/loadavg ]; then wait_for_rest; fi

rm -rf "$report_folder"
mkdir -p "$report_folder"

# run_suite NAME REPETITIONS SECONDS: a repetition iterates for at least so long. The suites that go up to a million
# balls take one iteration of those in a repetition, so the repetitions are what their medians and ratios come from.
run_suite() {
  local suite=$1 repetitions=$2 seconds=$3
  if [ "$quick" = yes ]; then repetitions=1 seconds=0.001; fi
  printf '== %s\n' "$suite"
  "$build_folder/bench/$suite" --benchmark_repetitions="$repetitions" --benchmark_min_time="$seconds" \
    --benchmark_display_aggregates_only=true --benchmark_out_format=json --benchmark_out="$report_folder/$suite.json"
}
run_suite bench_paper_section_2 5 0.02
run_suite bench_paper_section_3 5 0.02
run_suite bench_section_3_alternatives 3 0.02
run_suite bench_paper_section_4_2 5 0.02
run_suite bench_paper_section_5_1 5 0.02
run_suite bench_topology 7 0.05
run_suite bench_gradients 7 0.05
run_suite bench_scaling 3 0.02
run_suite bench_queries 5 0.02
run_suite bench_degenerate 5 0.02
if [ "$peers" = yes ]; then
  # These take their turns within one repetition.
  run_suite bench_peers_surfaces 1 0.02
  run_suite bench_peers_queries 1 0.02
fi

"$build_folder/bench/write_report" "$report_folder" >"$report_folder/report.md"
printf 'The report is %s\n' "$report_folder/report.md"
