#!/usr/bin/env bash
# README.md (From C) and the pages of capi/guide say what happens. Of each the blocks in C, one after another, are a program; the blocks of shell
# compile and run it and more; what all of these print are the blocks of text. The files that it writes and the page shows
# lie beside the page. A page without blocks of C has no program.
#   guide_pages.sh SOURCE-FOLDER ARCHIVE WORK-FOLDER C-COMPILER
# The commands `gcc` and `pkg-config` are stand-ins here, for the compiler with warnings as errors and for the library as
# built. A page that needs OpenMP is left out, and named, where there is none.
set -euo pipefail
source=$1 archive=$2 work=$3 cc=$(command -v "$4")
rm -rf "$work"
mkdir -p "$work/bin"
cat >"$work/bin/gcc" <<GCC
#!/bin/sh
exec "$cc" -Wall -Wextra -Wpedantic -Werror "\$@"
GCC
cat >"$work/bin/pkg-config" <<PKG_CONFIG
#!/bin/sh
echo "-I$source/include $archive -lm"
PKG_CONFIG
chmod +x "$work/bin/gcc" "$work/bin/pkg-config"
PATH=$work/bin:$PATH

missing() { # what a page needs that is not here
  if grep -q -e -fopenmp "$1" && ! echo 'int main(void) { return 0; }' | gcc -fopenmp -x c -o /dev/null - 2>/dev/null; then
    echo OpenMP
  fi
}

try() { # page
  local page=$1 section=${2:-} name folder c
  folder=$work/$(basename "$page" .md)
  mkdir -p "$folder/blocks"
  awk -v folder="$folder/blocks" -v section="$section" -f "$source/tests/packaging/page_blocks.awk" "$page"
  c=("$folder"/blocks/*.c)
  name=$(cat "$folder"/blocks/*.sh | grep -oE '[a-z_]+\.c\b' | head -n 1)
  cat "${c[@]}" >"$folder/$name"
  cat "$folder"/blocks/*.text >"$folder/expected"
  cp "$source/bench/molecules/crambin.pdb" "$folder"
  (cd "$folder" && bash -euo pipefail -c "$(cat blocks/*.sh)") >"$folder/printed" 2>&1 ||
    { cat "$folder/printed" && echo "$page: its commands failed" && return 1; }
  diff "$folder/expected" "$folder/printed" || { echo "$page: < what it shows, > what is printed" && return 1; }
  for picture in "$source/capi/guide"/*.svg; do
    if grep -qF "$(basename "$picture")" "$page"; then cmp "$picture" "$folder/$(basename "$picture")" || return 1; fi
  done
  # A tutorial: after each step the last block makes what is there a program.
  if grep -q '^## 1\. ' "$page"; then
    for ((step = 1; step < ${#c[@]}; ++step)); do
      cat "${c[@]:0:step}" "${c[-1]}" | "$cc" -std=c99 -Wno-all -I"$source/include" -fsyntax-only -x c - ||
        { echo "$page: step $step is no program" && return 1; }
    done
    # It takes a file as a whole or not at all: one has no such records, the other one more than there is room for.
    for other in caffeine sod_stand_in; do
      if (cd "$folder" && "./${name%.c}" "$source/bench/molecules/$other.pdb") >"$folder/refused" 2>&1; then
        cat "$folder/refused"
        echo "$page: its program takes $other"
        return 1
      fi
    done
  fi
  echo "$(basename "$page"): ${#c[@]} blocks of C, $(wc -l <"$folder/printed") lines printed"
}

pages=("$source"/capi/guide/*.md)
[ ${#pages[@]} -ge 16 ] || { echo "only ${#pages[@]} pages were found" && exit 1; }
try "$source/README.md" "## From C"
for page in "${pages[@]}"; do
  grep -q '^```c$' "$page" || continue
  tool=$(missing "$page")
  if [ -n "$tool" ]; then
    echo "$(basename "$page") is left out: there is no $tool here"
  else
    try "$page"
  fi
done
rm -rf "$work"
