#!/bin/bash
# Runs every benchmark and writes build/bench/report/report.md, with the paper's figures beside ours.
# Usage: bash bench/run.sh [--quick] [--peers | --programs]
#   --quick  one repetition of each benchmark, as short as it gets: for trying out, not for quoting
#   --peers  time other programs by turns with the library: FreeSASA, CGAL, nanoflann, gemmi, FCL, on a trajectory gmx
#            sasa and mdtraj, and these and FreeSASA from files to areas. Missing ones are installed from Debian's
#            packages if they can be, and left out otherwise. Then version 0.1.0 of the library, if it is in the
#            repository's history
#   --programs  nothing but these programs, from files to areas: their part of bench/report.md is put in place
# Missing packages are installed with apt-get (as root, or through sudo). The environment variable BENCH_BUILD names
# another folder to build in. Takes ten to twenty-five minutes, once the machine has come to rest after building.
# Committed of it are bench/report.md and bench/plots/*.svg.
set -euo pipefail

quick=no
peers=no
programs=no
for argument in "$@"; do
  case "$argument" in
    --quick) quick=yes ;;
    --peers) peers=yes ;;
    --programs) peers=yes programs=yes ;;
    *) sed -n '2,12s/^# //p' "$0" >&2; exit 2 ;;
  esac
done

source_folder=$(cd "$(dirname "$0")/.." && pwd)
build_folder=${BENCH_BUILD:-$source_folder/build/bench}
report_folder=$build_folder/report

# shellcheck source=.ci/install.sh
. "$source_folder/.ci/install.sh"
install_packages binutils cmake g++ libbenchmark-dev ninja-build
install_optional_packages gnuplot-nox
if [ "$peers" = yes ]; then install_optional_packages "${packages_of_peers[@]}"; fi

cmake -S "$source_folder" -B "$build_folder" -G Ninja -DCMAKE_BUILD_TYPE=Release -DHSP_BENCH=ON \
  -DHSP_TESTS=OFF -DHSP_TOOL=$peers -DHSP_FUZZ=OFF -DHSP_FORTRAN=OFF -DHSP_BENCH_PEERS=$peers
suites=(bench_paper_section_2 bench_paper_section_3 bench_section_3_alternatives bench_paper_section_4_2
  bench_paper_section_5_1 bench_maps bench_topology bench_gradients bench_contacts bench_surface bench_scaling
  bench_queries bench_poses bench_periodic bench_bricks bench_hessians bench_moving bench_split_work bench_degenerate)
if [ "$peers" = yes ]; then
  suites+=(bench_peers_surfaces bench_peers_dense bench_peers_queries bench_peers_visibility bench_peers_poses hardsphere_tool)
fi
if [ "$programs" = yes ]; then suites=(hardsphere_tool); fi
if [ "$peers" = yes ]; then
  suites+=(read_alone)
  if ninja -C "$build_folder" -t query gemmi_read >/dev/null 2>&1; then suites+=(gemmi_read); fi
fi
cmake --build "$build_folder" --target "${suites[@]}" write_report

# Version 0.1.0, with its own benchmarks and the one for lattices, which it had not.
old_version=cb10991
old_folder=$build_folder/0.1.0
old_suites=(bench_scaling bench_queries bench_topology bench_gradients bench_degenerate)
build_old_version() {
  mkdir -p "$old_folder"
  git -C "$source_folder" archive "$old_version" | tar -x -C "$old_folder"
  cp "$source_folder/bench/suites/bench_degenerate.cpp" "$old_folder/bench/"
  sed -i 's/bench_topology bench_gradients)/bench_topology bench_gradients bench_degenerate)/' "$old_folder/bench/CMakeLists.txt"
  cmake -S "$old_folder" -B "$old_folder/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DHSP_BENCH=ON \
    -DHSP_TESTS=OFF -DHSP_TOOL=OFF -DHSP_FUZZ=OFF -DHSP_FORTRAN=OFF >/dev/null
  cmake --build "$old_folder/build" --target "${old_suites[@]}"
}
old=no
if [ "$peers" = yes ] && [ "$programs" = no ]; then
  if ! git -C "$source_folder" cat-file -e "$old_version^{commit}" 2>/dev/null; then
    printf 'version 0.1.0: skipped: commit %s is not in this repository\n' "$old_version"
  elif [ -x "$old_folder/build/bench/bench_degenerate" ] || build_old_version; then
    old=yes
  fi
fi

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

quickly=()
if [ "$quick" = yes ]; then quickly=(--quick); fi
text=$source_folder/bench/report/text
run_programs() {
  printf '== %s\n' bench/peers/programs.py
  python3 "$source_folder/bench/peers/programs.py" "$build_folder" "$source_folder/bench/molecules/ubiquitin.pdb" \
    "$report_folder/peers_programs.json" "${quickly[@]}"
}
if [ "$programs" = yes ]; then
  run_programs
  mkdir "$report_folder/text"
  cp "$text/2_programs.txt" "$report_folder/text/"
  "$build_folder/bench/write_report" "$report_folder/text" "$report_folder" >"$report_folder/programs.md"
  printf 'This part was measured by itself, on %s: %s, %s processors, load average %s.\n\n' "$(date +%F)" \
    "$(sed -n 's/^model name.*: //p' /proc/cpuinfo | sed -n 1p)" "$(nproc)" "$(cut -d ' ' -f 1 /proc/loadavg)" \
    >>"$report_folder/programs.md"
  # In place of the part that is there, or at the end of the chapter.
  awk -v part="$report_folder/programs.md" '
    function put() { while ((getline line < part) > 0) if (line != "" || ++lines > 1) print line; done = 1 }
    /^##/ { ours = $0 == "### Programs, from files to areas" }
    ours && !done || /^## Section 2/ && !done { put() }
    !ours { print }' "$source_folder/bench/report.md" >"$report_folder/report.md"
  if [ "$quick" = no ]; then cp "$report_folder/report.md" "$source_folder/bench/report.md"; fi
  printf 'The part is %s\n' "$report_folder/programs.md"
  exit
fi

# run_suite NAME REPETITIONS SECONDS [SUFFIX]: a repetition iterates for at least so long. The suites that go up to a
# million balls take one iteration of those in a repetition, so the repetitions are what their medians and ratios come
# from. The report counts all repetitions of one benchmark, whatever files they are in.
run_suite() {
  run_program "$build_folder/bench/$1" "$report_folder/$1${4:-}.json" "$2" "$3"
}
# run_program PROGRAM RESULT REPETITIONS SECONDS [ARGUMENT...]
run_program() {
  local program=$1 result=$2 repetitions=$3 seconds=$4
  shift 4
  if [ "$quick" = yes ]; then repetitions=1 seconds=0.001; fi
  printf '== %s\n' "$program"
  "$program" --benchmark_repetitions="$repetitions" --benchmark_min_time="$seconds" \
    --benchmark_display_aggregates_only=true --benchmark_out_format=json --benchmark_out="$result" "$@"
}
run_suite bench_paper_section_2 5 0.02
run_suite bench_paper_section_3 5 0.02
run_suite bench_section_3_alternatives 3 0.02
run_suite bench_paper_section_4_2 5 0.02
run_suite bench_paper_section_5_1 3 0.02
run_suite bench_maps 3 0.02
run_suite bench_topology 5 0.05
run_suite bench_gradients 5 0.05
run_suite bench_contacts 5 0.05
run_suite bench_surface 5 0.05
run_suite bench_scaling 5 0.02
run_suite bench_queries 5 0.02
run_suite bench_poses 3 0.02
run_suite bench_periodic 3 0.02
run_suite bench_bricks 3 0.02
run_suite bench_hessians 3 0.02
run_suite bench_moving 5 0.02
run_suite bench_split_work 6 0.02
run_suite bench_degenerate 5 0.02
if [ "$peers" = yes ]; then
  # These take their turns within one repetition.
  run_suite bench_peers_surfaces 1 0.02
  run_suite bench_peers_dense 1 0.02
  run_suite bench_peers_queries 1 0.02
  run_suite bench_peers_visibility 1 0.02  # half a minute, once
  run_suite bench_peers_poses 1 0.02
  printf '== %s\n' bench/peers/trajectories.py
  python3 "$source_folder/bench/peers/trajectories.py" "$build_folder/capi/hardsphere" \
    "$source_folder/bench/molecules/ubiquitin.pdb" "$report_folder/peers_trajectories.json" "${quickly[@]}"
  run_programs
fi
# Other work of a machine comes and goes in minutes, and would make a set look smaller or larger than it is. So suites
# that compare sizes or threads run twice more.
if [ "$quick" = no ]; then
  for again in .second .third; do
    for suite in bench_topology bench_gradients bench_contacts bench_surface; do run_suite "$suite" 5 0.05 "$again"; done
    run_suite bench_scaling 5 0.02 "$again"
    run_suite bench_periodic 3 0.02 "$again"
    run_suite bench_split_work 6 0.02 "$again"
  done
fi
# Limits that are times scale with what version 0.1.0 takes. A processor's clock changes while the suites run, so in what
# these goals are about the versions take turns: round after round, in folders of their own.
run_turns() {
  local suite=$1 filter=$2
  run_program "$build_folder/bench/$suite" "$report_folder/turns/now/$suite.$round.json" 2 0.05 \
    --benchmark_filter="$filter"
  if [[ " ${old_suites[*]} " == *" $suite "* ]]; then
    run_program "$old_folder/build/bench/$suite" "$report_folder/turns/0.1.0/$suite.$round.json" 2 0.05 \
      --benchmark_filter="$filter"
  fi
}
if [ "$old" = yes ]; then
  mkdir -p "$report_folder/turns/now" "$report_folder/turns/0.1.0"
  rounds=10
  if [ "$quick" = yes ]; then rounds=1; fi
  for ((round = 1; round <= rounds; ++round)); do
    run_turns bench_scaling '/(build|lists|pairs|boundary|everything)/sod_stand_in$'
    run_turns bench_queries '_atom/sod_stand_in$'
    run_turns bench_topology '/compute/sod_stand_in$'
    run_turns bench_gradients '/compute/sod_stand_in$'
    run_turns bench_degenerate .
    run_turns bench_surface '/compute/sod_stand_in$'
    run_turns bench_paper_section_2 'free_space/.*/sod_stand_in$'
    run_turns bench_moving '/move_1/sod_stand_in$'
  done
fi

mkdir -p "$report_folder/plots"
"$build_folder/bench/write_report" --plots "$text" "$report_folder"
if ! command -v gnuplot >/dev/null; then
  printf 'no plots: gnuplot is not installed\n'
elif ! gnuplot -e "folder='$report_folder/plots'" "$source_folder/bench/report/plots.gp"; then
  printf 'no plots: gnuplot failed\n'
fi
"$build_folder/bench/write_report" "$text" "$report_folder" >"$report_folder/report.md"
printf 'The report is %s\nTo commit it:\n' "$report_folder/report.md"
printf '  mkdir -p bench/plots; cp %s bench/; cp %s bench/plots/\n' "$report_folder/report.md" "$report_folder/plots/*.svg"
