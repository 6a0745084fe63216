#!/usr/bin/env bash
# How many small mistakes the tests notice.
#   run.sh [NAME...]
# Makes the mutants of mutations.txt (all, or those named), each alone in a copy of the tree, and runs the tests
# until one fails. A mutant is killed if a test fails, crashes or takes far longer than without a mutation, else it has
# survived. Left out are slow tests and those of oracles, packages, other processors and of this folder.
# Writes what was found into mutations.txt. The exit status is 0 if every mutant compiled and survivors.txt explains
# every survivor.
# HSP_MUTATION_FOLDER (build/mutation) keeps the copies: a second run starts sooner. HSP_MUTATION_JOBS (as many as there
# are cores) mutants are tried at a time.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
source=$(cd "$here/../.." && pwd)
folder=${HSP_MUTATION_FOLDER:-$source/build/mutation}
jobs=${HSP_MUTATION_JOBS:-$(nproc)}
mutations=$here/mutations.txt
export LC_ALL=C

fail() {
  echo "mutation/run.sh: $*" >&2
  exit 1
}

mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
# Lines of mutations.txt: a name, a file and what noticed the mistake.
named() { awk '/^[a-z][0-9][0-9]+ [^ ]+( [a-z0-9_]+)?$/' "$1"; }
all_names=$(named "$mutations" | cut -d ' ' -f 1)
if [ $# -gt 0 ]; then names=("$@"); else mapfile -t names <<<"$all_names"; fi
# Left out here are those that slow tests, packages or other programs find, which are run by hand with the mistake made.
if [ $# -eq 0 ]; then mapfile -t names < <(named "$mutations" | awk '$3 !~ /^packaging_|_slow$|^clients_lammps$/ { print $1 }'); fi
for name in "${names[@]}"; do grep -qx "$name" <<<"$all_names" || fail "no mutation is called $name"; done
awk -v root="$source" -f "$here/mutations.awk" "$mutations" || fail "mutations.txt does not fit the code"

# The targets that are built and tested. Files that have not changed keep their times, so that only what has changed is
# built again.
checksums() { # of a tree: sum, size and name
  (
    cd "$1"
    find CMakeLists.txt LICENSE README.md .clang-format capi fuzz include lib tests bench -type f -print0 2>/dev/null |
      xargs -0r cksum | sort
  ) || true
}
synchronize() { # to a copy
  local tree=$1 file
  mkdir -p "$tree"
  checksums "$source" >"$folder/checksums"
  checksums "$tree" >"$folder/checksums_of_copy"
  comm -23 "$folder/checksums" "$folder/checksums_of_copy" | cut -d ' ' -f 3- | while read -r file; do
    mkdir -p "$tree/$(dirname "$file")"
    cp "$source/$file" "$tree/$file"
    case $file in tests/mutation/*) ;; *) rm -f "$folder/tests" ;; esac
  done
  comm -13 <(cut -d ' ' -f 3- "$folder/checksums" | sort) <(cut -d ' ' -f 3- "$folder/checksums_of_copy" | sort) |
    while read -r file; do rm "$tree/$file"; done
}
for ((copy = 0; copy < jobs; ++copy)); do
  tree=$folder/$copy/tree
  # A mutant of an interrupted run.
  if [ -d "$folder/$copy/work/saved" ]; then rm -rf "$folder/$copy/work/saved" "$folder/tests"; fi
  synchronize "$tree"
  echo "building copy $((copy + 1)) of $jobs"
  cmake -G Ninja -S "$tree" -B "$tree/build/mutation" -DCMAKE_BUILD_TYPE=Release -DHSP_BENCH=OFF -DHSP_FORTRAN=OFF \
    -DHSP_CHECKED_LIBRARY=ON -DHSP_UNITY_BUILD=OFF -DHSP_INSTALL=OFF -DHSP_TOOL_STATIC=OFF \
    -DCMAKE_LINK_DEPENDS_NO_SHARED=ON -DCMAKE_PROJECT_INCLUDE="$tree/tests/mutation/one_shared_object.cmake" \
    >"$folder/$copy/build.log" 2>&1 || fail "cannot configure; see $folder/$copy/build.log"
  ninja -C "$tree/build/mutation" -j "$jobs" >"$folder/$copy/build.log" 2>&1 || fail "cannot build; see $folder/$copy/build.log"
done

# try.sh learns from a dry run what a mutant overwrites; one that stops at CMake would tell nothing.
for ((copy = 0; copy < jobs; ++copy)); do
  if ninja -C "$folder/$copy/tree/build/mutation" -n all | grep -q 'Re-running CMake'; then
    fail "ninja wants to run CMake again before every build: is there a glob with CONFIGURE_DEPENDS?"
  fi
done

# The tests, each with its seconds and its command. A kill means something only if the test passes without a mutation.
tree=$folder/0/tree
build=$tree/build/mutation
if [ ! -e "$folder/tests" ]; then
  for left_out in oracle packaging portability mutation; do
    [ -d "$build/tests/$left_out" ] || fail "tests/$left_out is no longer there"
    ctest --test-dir "$build/tests/$left_out" -N
  done | sed -n 's/^ *Test *#[0-9]*: //p' >"$folder/left_out"
  echo "running all tests without a mutation"
  ctest --test-dir "$build" -E "_slow\$|^($(paste -s -d '|' "$folder/left_out"))\$" -j "$jobs" --timeout 600 >"$folder/tests.log" 2>&1 || true
  sed -nE 's/^ *[0-9]+\/[0-9]+ Test +#[0-9]+: ([^ ]+) \.*\** *(Failed|Exception|Timeout|Not Run).*/left out, as it fails without a mutation: \1/p' \
    "$folder/tests.log"
  ctest --test-dir "$build" -N -V | awk -v OFS='\t' '
    FILENAME != "-" { if ($0 ~ / Passed /) { sub(/^.*Test +#[0-9]+: /, ""); seconds[$1] = $(NF - 1) } next }
    / Test command: / { command = $0; sub(/^.* Test command: /, "", command) }
    /^ *Test +#[0-9]+: / { if ($NF in seconds) print $NF, seconds[$NF], command }' "$folder/tests.log" - >"$folder/tests.new"
  mv "$folder/tests.new" "$folder/tests"
fi
echo "$(wc -l <"$folder/tests") tests, ${#names[@]} mutants"

# The tests that noticed the mutants tried replace those of before.
: >"$folder/verdicts"
keep_results() {
  awk -v verdicts="$folder/verdicts" '
    BEGIN { while ((getline line < verdicts) > 0) if (split(line, word, ",")) found[word[1]] = word[3] != "" ? word[3] : word[2] }
    /^[a-z][0-9][0-9]+ [^ ]+( [a-z0-9_]+)?$/ && $1 in found { $0 = $1 " " $2 (found[$1] ~ / / ? "" : " " found[$1]) }
    { print }' "$folder/mutations_before.txt" >"$mutations"
}
cp "$mutations" "$folder/mutations_before.txt"
trap keep_results EXIT
printf '%s\n' "${names[@]}" | xargs -P "$jobs" -n 1 --process-slot-var=HSP_MUTATION_COPY \
  bash "$here/try.sh" "$folder" "$mutations" || true
keep_results
trap - EXIT

# News: verdicts that have changed, survivors without an explanation.
awk -F, 'NR == FNR { if (NF == 3) before[$1] = $3 == "survived" ? $3 : "killed"; next }
  $1 in before && before[$1] != $2 { print $1 ": " $2 ", before: " before[$1] }' <(named "$folder/mutations_before.txt" | tr ' ' ,) \
  <(sort "$folder/verdicts")
awk -F, '{ ++verdicts[$2] } END { printf "%d mutants: %d killed, %d survived, %d did not compile\n", NR,
  verdicts["killed"], verdicts["survived"], verdicts["did not compile"] }' "$folder/verdicts"
[ "$(wc -l <"$folder/verdicts")" -eq ${#names[@]} ] || fail "not all of ${#names[@]} were tried"
unexplained=$(comm -23 <(sed -n 's/,survived,$//p' "$folder/verdicts" | sort) <(grep -oE '^[a-z][0-9]{2,3} ' "$here/survivors.txt" | tr -d ' ' | sort))
[ -z "$unexplained" ] || fail "survivors that survivors.txt does not explain: ${unexplained//$'\n'/ }"
! grep -q 'did not compile' "$folder/verdicts" || fail "some did not compile"
