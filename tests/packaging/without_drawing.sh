#!/usr/bin/env bash
# The program without the part that draws (HSP_TOOL_DRAW=OFF), of the library that is there: its build leaves out the
# whole folder, it has the same tables, needs nothing of the library's component sight, and says in one sentence what is
# left out.
#   without_drawing.sh SOURCE-FOLDER WORK-FOLDER PROGRAM LIBRARY READERS C-COMPILER C++-COMPILER
set -euo pipefail
export LC_ALL=C
source=$1 work=$2 program=$3 library=$4 readers=$5 cc=$6 cxx=$7
inputs=$source/tests/program/inputs/good
rm -rf "$work"
mkdir -p "$work/with" "$work/without"
failed=0
complain() {
  echo "$*"
  failed=1
}

cmake -S "$source" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=None -DCMAKE_C_COMPILER="$cc" \
  -DCMAKE_CXX_COMPILER="$cxx" -DHSP_TOOL=ON -DHSP_TOOL_DRAW=OFF -DHSP_TESTS=OFF -DHSP_BENCH=OFF -DHSP_FUZZ=OFF -DHSP_FORTRAN=OFF \
  -DHSP_WERROR=ON -DCMAKE_EXPORT_COMPILE_COMMANDS=ON >"$work/log" || { cat "$work/log" && exit 1; }
if grep 'program/draw/' "$work/build/compile_commands.json"; then complain "HSP_TOOL_DRAW=OFF compiles what draws"; fi
# All but the library and what reads files, which the option does not change. Not optimised: that takes half of the time.
table=capi/CMakeFiles/hardsphere_tool.dir/program/app/command_table.c.o
ninja -C "$work/build" hardsphere_program hardsphere_program_components $table >"$work/log" ||
  { tail -n 40 "$work/log" && exit 1; }
without=$work/hardsphere
mapfile -t objects < <(find "$work/build/capi/CMakeFiles/hardsphere_program"* -name '*.o')
"$cc" "$work/build/$table" "${objects[@]}" "$readers" "$library" -Wl,--gc-sections \
  -lm -pthread -o "$without"

# Functions of the component sight.
for header in view map picture sticks; do
  sed 's,/\*.*\*/,,' "$source/include/hardsphere/$header.h" | grep -oE '^HSP_API [^(]*\(' | grep -oE 'hsp_[a-z0-9_]+'
done | sort -u >"$work/sight"
[ "$(wc -l <"$work/sight")" -gt 20 ] || complain "no functions of sight are known"
nm "$program" | awk '{print $NF}' | sort -u | comm -12 - "$work/sight" | grep -q . ||
  complain "nm does not see functions of sight"
nm "$without" | awk '{print $NF}' | sort -u | comm -12 - "$work/sight" >"$work/needed"
[ ! -s "$work/needed" ] || complain "the program without drawing has $(tr '\n' ' ' <"$work/needed")"

# All that does not draw has the same bytes, files and exit status.
same() {
  local which status
  for which in with without; do
    status=0
    (cd "$work/$which" && "$([ $which = with ] && echo "$program" || echo "$without")" "$@" >out 2>err) || status=$?
    echo $status >>"$work/$which/out"
  done
  diff -r "$work/with" "$work/without" >"$work/difference" || complain "$* differs: $(head -n 3 "$work/difference")"
}
ubiquitin=$source/bench/molecules/ubiquitin.pdb water=$inputs/water.pdb caffeine=$source/bench/molecules/caffeine.pdb
for command in model boundary measure voids contacts complex cells pores "query --point 27,29,15" "gate --from 27,29,15" \
  "path --from 0,0,0 --to 60,60,60"; do
  # shellcheck disable=SC2086
  same $command "$ubiquitin" --probe 1.4 --no-water
  # shellcheck disable=SC2086
  same $command "$ubiquitin" --json
done
same measure "$ubiquitin" --csv --probe 1.4
same measure "$caffeine" --surface ses --probe 1.4 --polar
same contacts "$ubiquitin" --by residue --csv
same pores "$caffeine" --points points.pdb
same clash "$water" "$caffeine" --translate 3,0,0
same mesh "$caffeine" -o out.ply
same measure --help
same --help
same measure "$ubiquitin" --by

"$without" draw --help >"$work/out" && grep -q 'Draws the balls' "$work/out" || complain "draw has no help"

# The rest is refused with status 2.
refused() {
  local said status=0 expected="hardsphere: $1 needs the part that draws, which this build leaves out"
  shift
  said=$("$without" "$@" 2>&1) || status=$?
  [ "$said" = "$expected" ] && [ $status -eq 2 ] || complain "$*: status $status, $said"
}
for command in map pick draw; do refused $command $command "$water" -o -; done
refused "clash --rotate" clash "$water" "$water" --rotate 0,0,90
refused "contacts --map" contacts "$water" --map "$work/map.svg"
refused "pores --profile" pores "$water" --profile "$work/profile.svg"
refused "pores --tree" pores "$water" --tree="$work/tree.svg"
refused "mesh -o OUT.svg" mesh "$water" -o "$work/mesh.svg"
refused "mesh -o OUT.svg" mesh "$water" -o - --triangles svg
[ $failed -eq 0 ] && rm -rf "$work"
exit $failed
