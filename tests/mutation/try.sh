#!/usr/bin/env bash
# Makes one mutant in one of the copies that run.sh has prepared, and runs the tests until one fails. Called by run.sh:
#   HSP_MUTATION_COPY=NUMBER try.sh FOLDER MUTATIONS NAME
# Appends a line to FOLDER/verdicts: the name, `killed`, `survived` or `did not compile`, and the test that killed it.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
folder=$1 mutations=$2 name=$3
tree=$folder/$HSP_MUTATION_COPY/tree
build=$tree/build/mutation
work=$folder/$HSP_MUTATION_COPY/work
file=$(awk -v name="$name" '$1 == name { print $2; exit }' "$mutations")
export LC_ALL=C
# No object of a mutant is worth keeping.
export CCACHE_DISABLE=1

# Files that are overwritten for a mutant are put back afterwards as they were, with their time, so that the next mutant
# need not build them again. The source comes last: should this be interrupted, run.sh sees that it differs.
saved=$work/saved
put_back() {
  if [ -d "$saved/build" ]; then cp -a "$saved/build/." "$build/"; fi
  if [ -f "$saved/source" ]; then cp -a "$saved/source" "$tree/$file"; fi
  rm -rf "$saved"
}

# The files that building these targets would write.
outputs_of() {
  ninja -C "$build" -n "$@" | awk '/^\[.*\] (Building|Linking) / { print $NF }'
}

build_targets() {
  outputs_of "$@" | (
    cd "$build"
    while read -r output; do
      if [ -e "$output" ] && [ ! -e "$saved/build/$output" ]; then cp -a --parents "$output" "$saved/build"; fi
    done
  )
  ninja -C "$build" -j 1 "$@" >"$work/build.log" 2>&1
}

# Tests fail that take far more processor time than without a mutation, or more memory than any needs.
test_passes() { # name, seconds without a mutation
  (
    ulimit -t $((5 + 4 * ${2%.*}))
    ulimit -v $((8 << 20))
    ctest --test-dir "$build" -R "^$1\$" --timeout 600 >"$work/test.log" 2>&1
  )
}

# The tests of FOLDER/tests in the order in which they are tried: the one that killed this mutant before; those that
# killed others of the same file, and the unit test of that name; those of the same folder, the most frequent first;
# those whose names have words of the file's; then the quickest first, at the end those that have to be linked again. A
# line is the test's seconds, its name and what has to be built for it, if anything.
ordered_tests() {
  awk -F '[,\t]' -v name="$name" -v file="$file" -v mutations="$mutations" -v affected="$work/affected" \
    -v room="$(basename "$(dirname "$file")")" -v unit="$(basename "${file%%.*}")" '
    function folder_of(path) { sub("/[^/]*$", "", path); return path }
    function count_test(mutant, test) {
      if (mutant == name) score[test] += 1000000
      if (file_of[mutant] == file) score[test] += 1000
      if (folder_of(file_of[mutant]) == folder_of(file)) score[test] += 1
    }
    BEGIN {
      while ((getline line < mutations) > 0) {
        if (line !~ /^[a-z][0-9][0-9]+ [^ ]+( [a-z0-9_]+)?$/) continue
        words = split(line, word, " ")
        file_of[word[1]] = word[2]
        if (words == 3 && word[3] != "survived") count_test(word[1], word[3])
      }
      while ((getline line < affected) > 0) executables[++count] = line
      score["unit_" room "_" unit] += 500
      words = split(room "_" unit, word_of_file, "_")
    }
    FILENAME == ARGV[1] {
      if ($3 != "") count_test($1, $3)
      next
    }
    {
      target = ""
      for (k = 1; k <= count; ++k) if (index($3 " ", "/" executables[k] " ") || index($3, "/" executables[k] "\"")) target = executables[k]
      for (k = 1; k <= words; ++k) {
        sub(/s$/, "", word_of_file[k])
        if (index($1, "_" word_of_file[k])) score[$1] += 0.1
      }
      printf "%.1f %d %s %s %s\n", score[$1], target != "", $2, $1, target
    }' "$folder/verdicts" "$folder/tests" | sort -k1,1nr -k2,2n -k3,3n | cut -d ' ' -f 3-
}

# Sets verdict and killer.
try_mutant() {
  local seconds test target
  verdict='did not compile' killer=
  # Executables that no command begins with are what tests run: built at once. Tests are built when their turn comes.
  outputs_of all | awk '!/\.(o|a|so)$/' >"$work/affected"
  mapfile -t programs < <(while read -r executable; do
    cut -f 3 "$folder/tests" | grep -qE "^[^ ]*/$executable\"?( |\$)" || echo "$executable"
  done <"$work/affected")
  build_targets hardsphere_mutant "${programs[@]}" || return 0
  ordered_tests >"$work/order"
  while read -r seconds test target <&3; do
    if [ -n "$target" ]; then build_targets "$target" || return 0; fi
    if ! test_passes "$test" "$seconds"; then
      verdict=killed killer=$test
      return 0
    fi
  done 3<"$work/order"
  verdict=survived
}

mkdir -p "$work"
put_back
mkdir -p "$saved/build"
cp -a "$tree/$file" "$saved/source"
trap put_back EXIT
awk -v name="$name" -v root="$tree" -f "$here/mutations.awk" "$mutations" >&2
start=$SECONDS
try_mutant
printf '%s,%s,%s\n' "$name" "$verdict" "$killer" >>"$folder/verdicts"
printf '%-4s %-34s %s%s, %d s\n' "$name" "$file" "$verdict" "${killer:+ by $killer}" $((SECONDS - start))
