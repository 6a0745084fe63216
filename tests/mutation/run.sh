#!/usr/bin/env bash
# How many small mistakes in lib/ the tests find.
#   run.sh [NAME...]
# Makes the mutations of mutations.txt (all, or those named), each in a scratch copy of the tree, builds what it
# concerns and runs the tests without `slow`, those that are quick and look at much first, until one fails. A mutation
# is killed if a test fails, crashes or takes longer than a minute, else it has survived; README.md of this folder
# judges the survivors. The exit status is 0 if every survivor is named there in the list of survivors.
# The copy is kept in HSP_MUTATION_FOLDER (default: build/mutation), so that a second run starts sooner. With
# HSP_MUTATION_TESTS only the tests named in it are run.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
source=$(cd "$here/../.." && pwd)
folder=${HSP_MUTATION_FOLDER:-$source/build/mutation}
list=$here/mutations.txt
tree=$folder/tree
build=$folder/build
jobs=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}

fail() {
  echo "mutation/run.sh: $*" >&2
  exit 1
}

# Tests in the order in which they are tried, with the targets that they need, in groups: what a group needs is built
# only if the groups before it found nothing. The last group is all that is left.
interface='api_boundary_closed_forms api_boundary_properties api_query_hits api_query_lengths api_model_figures
  api_boundary_handles api_model_arguments api_query_arguments api_boundary_arguments api_boundary_limits
  api_boundary_capacity api_boundary_memory differential_model_figures differential_query_hits
  differential_boundary_geometry differential_boundary_nerve fuzz_model_replay fuzz_queries_replay
  fuzz_boundary_replay fuzz_interface_replay'
inner='pair_and_order_test far_pairs_test wide_integer_test lattice_test cap_pair_test cube_table_test cube_order_test
  structure_memory_test structure_check_test meridian_walks_test predicate_rungs_test tie_rule_test
  tie_rule_largest_values_test elementary_test'
oracle='differential_boundary_brute_force differential_measure_quadrature'
# Tried first for mistakes in what the topology is made of.
topology='quad_edges_test orientation_test start_faces_test topology_check_test topology_memory_test
  shell_measures_test extra_arcs_test split_points_test api_topology_locate api_topology_capacity api_topology_limits
  api_topology_properties api_topology_handles vertical_order_test vertical_ray_test great_circles_test
  differential_topology_built_sets differential_topology_nesting differential_topology_betti_numbers
  differential_topology_molecules'
# Tried first for mistakes in views and in pictures.
views='view_frame_test depth_order_test hidden_balls_test api_view_arguments api_view_limits api_view_turn
  api_view_handles differential_view_turned_views api_view_capacity api_view_properties fuzz_view_replay
  differential_view_painter differential_view_pieces differential_view_molecules'
pictures='pictures_text pictures_sizes pictures_arcs api_picture_arguments api_picture_properties program_draw_colours
  program_draw pictures_renderers'

# What the build folder knows of the given targets.
known() {
  local target
  for target in "$@"; do
    if grep -qx "$target: phony" "$folder/targets" || grep -q "^$target: " "$folder/targets"; then echo "$target"; fi
  done
}

# The test of a fuzz harness is called as its area.
tests_of() {
  printf '%s\n' "$@" | sed -E 's/^(fuzz_.*)_replay$/\1/'
}

build_targets() {
  ninja -C "$build" -j "$jobs" "$@" >"$folder/build.log" 2>&1
}

# Runs the named tests one after the other; prints the first that fails.
first_failure() {
  local test
  for test in "$@"; do
    if [[ " ${left_out[*]} " == *" $test "* ]]; then continue; fi
    ctest --test-dir "$build" -R "^$test\$" -LE slow --timeout 60 >"$folder/test.log" 2>&1 || {
      echo "$test"
      return 0
    }
  done
  return 1
}

# The groups in the order that suits a file.
groups_for() {
  groups=("$interface" "$inner" "$oracle" "$topology" "$views" "$pictures")
  case $1 in
    lib/topology/* | lib/boundary/great_circles.* | lib/grid/vertical_ray.* | lib/exact/vertical_order.* | \
      lib/measure/places.* | lib/measure/shell_measures.*)
      groups=("$topology" "$interface" "$inner" "$oracle" "$views" "$pictures") ;;
    lib/view/*) groups=("$views" "$pictures" "$interface" "$inner" "$oracle" "$topology") ;;
    lib/picture/*) groups=("$pictures" "$views" "$interface" "$inner" "$oracle" "$topology") ;;
    lib/core/elementary.*) groups=("$inner" "$pictures" "$views" "$interface" "$oracle" "$topology") ;;
  esac
  if [ -n "${HSP_MUTATION_TESTS:-}" ]; then groups=("$HSP_MUTATION_TESTS"); fi
}

# Sets verdict, killer.
try_tree() {
  local group tests
  verdict=survived
  killer=
  for group in "${groups[@]}"; do
    # shellcheck disable=SC2086
    mapfile -t targets < <(known $group)
    if ! build_targets "${targets[@]}"; then
      verdict='did not compile'
      return
    fi
    mapfile -t tests < <(tests_of "${targets[@]}")
    if killer=$(first_failure "${tests[@]}"); then
      verdict=killed
      return
    fi
  done
  if [ -n "${HSP_MUTATION_TESTS:-}" ]; then return; fi
  if ! build_targets all; then
    verdict='did not compile'
    return
  fi
  mapfile -t tests < <(ctest --test-dir "$build" -N -LE slow | sed -n 's/^ *Test *#[0-9]*: //p' |
    grep -vxF -f <(tests_of $interface $inner $oracle $topology $views $pictures) |
    grep -vE '^(packaging|oracle)_')
  if killer=$(first_failure "${tests[@]}"); then verdict=killed; fi
}

mkdir -p "$tree"
# Files that have not changed keep their times, so that only what has changed is built again.
(cd "$source" && find CMakeLists.txt LICENSE README.md .clang-format capi fuzz include lib tests bench -type f) |
  while read -r file; do
    mkdir -p "$tree/$(dirname "$file")"
    cmp -s "$source/$file" "$tree/$file" || cp "$source/$file" "$tree/$file"
  done
cmake -G Ninja -S "$tree" -B "$build" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_C_FLAGS=-O1 -DCMAKE_CXX_FLAGS=-O1 \
  -DHSP_BENCH=OFF -DHSP_FORTRAN=OFF >"$folder/configure.log" 2>&1 || fail "cannot configure; see $folder/configure.log"
ninja -C "$build" -t targets all >"$folder/targets"

if [ $# -gt 0 ]; then names=("$@"); else mapfile -t names < <(grep -oE '^[a-z][0-9]{2} ' "$list" | tr -d ' '); fi

# A kill means something only if the test passes without a mutation.
left_out=()
groups_for ''
try_tree
while [ "$verdict" = killed ]; do
  echo "left out, as it fails without a mutation: $killer"
  left_out+=("$killer")
  try_tree
done
[ "$verdict" = survived ] || fail "without a mutation: $verdict; see $folder/build.log"

declare -A counted=([killed]=0 [survived]=0 [did not compile]=0)
unexplained=()
for name in "${names[@]}"; do
  file=$(awk -v name="$name" '$1 == name { print $2; exit }' "$list")
  [ -n "$file" ] || fail "no mutation is called $name"
  cp "$tree/$file" "$folder/pristine"
  LC_ALL=C awk -v name="$name" -v root="$tree" -f "$here/apply.awk" "$list" ||
    fail "$name: its text does not stand in $file exactly once"
  groups_for "$file"
  try_tree
  cp "$folder/pristine" "$tree/$file"
  counted[$verdict]=$((counted[$verdict] + 1))
  printf '%-4s %-34s %s%s\n' "$name" "$file" "$verdict" "${killer:+ by $killer}"
  if [ "$verdict" = survived ] && ! grep -q "^| $name " <(sed -n '/^## Survivors/,$p' "$here/README.md"); then
    unexplained+=("$name")
  fi
done
echo "${#names[@]} mutations: ${counted[killed]} killed, ${counted[survived]} survived," \
  "${counted[did not compile]} did not compile"
[ ${#unexplained[@]} -eq 0 ] || fail "survivors that README.md does not explain: ${unexplained[*]}"
