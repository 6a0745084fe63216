#!/usr/bin/env bash
# The first C example of README.md, as it stands there, compiles without a warning, links and runs.
#   readme_example.sh README.md INCLUDE-FOLDER ARCHIVE WORK-FOLDER C-COMPILER
set -euo pipefail
readme=$1 include=$2 archive=$3 work=$4 cc=$5
rm -rf "$work"
mkdir -p "$work"
if [ ! -e "$readme" ]; then
  echo "there is no $readme"
  exit 1
fi
awk '/^```c[[:space:]]*$/ && !done {inside = 1; next} /^```/ && inside {inside = 0; done = 1} inside' "$readme" >"$work/example.c"
if ! grep -q 'int main' "$work/example.c"; then
  echo "README.md has no C example with a main function"
  exit 1
fi
grep -q 'hsp_' "$work/example.c" || { echo "README.md's example does not use the library" && exit 1; }
"$cc" -std=c99 -Wall -Wextra -Wpedantic -Wstrict-prototypes -Werror -I"$include" -o "$work/example" "$work/example.c" \
  "$archive" -lm
"$work/example"
