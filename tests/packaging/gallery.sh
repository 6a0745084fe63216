#!/usr/bin/env bash
# Every picture in README.md is what one command line of README.md writes, byte for byte.
#   gallery.sh SOURCE-FOLDER WORK-FOLDER PROGRAM [--write]
# --write: write the pictures anew, where they are meant to change.
set -euo pipefail
source=$1 work=$2 program=$(realpath "$3") write=${4:-}
pictures=tests/program/pictures
rm -rf "$work"
mkdir -p "$work/bin" "$work/run"
ln -s "$program" "$work/bin/hardsphere"
PATH=$work/bin:$PATH
export LC_ALL=C
cp "$source"/bench/molecules/*.pdb "$work/run"
cp "$source/bench/molecules/crambin.pdb" "$work/run/1crn.pdb"

# Lines of code, and code within the text; three blanks end a line.
{
  sed -n 's/^ *\(hardsphere [-a-z].*\)/\1/p' "$source/README.md" | sed -E 's/ {3,}.*//'
  # shellcheck disable=SC2016 # these are Markdown's
  grep -oh '`hardsphere [^`]*`' "$source/README.md" | tr -d '`'
} >"$work/lines"
grep -oE "$pictures/[^)\" ]*" "$source/README.md" | sort -u >"$work/shown"
[ "$(wc -l <"$work/shown")" -ge 9 ] || { cat "$work/shown" && echo "are all the pictures that were found" && exit 1; }

failed=0
while read -r picture; do
  name=${picture##*/}
  grep -E -- "(-o|--map) ${name//./\\.}( |\$)" "$work/lines" >"$work/line" || true
  if [ "$(wc -l <"$work/line")" -ne 1 ]; then
    echo "$name: README.md has $(wc -l <"$work/line") command lines that write it"
    failed=1
    continue
  fi
  line=$(cat "$work/line")
  (cd "$work/run" && bash -c "$line" >/dev/null) || { echo "\$ $line fails" && exit 1; }
  if [ "$write" = --write ]; then
    cp "$work/run/$name" "$source/$picture"
  elif ! cmp "$work/run/$name" "$source/$picture"; then
    echo "\$ $line does not write $picture; if it is meant to change: gallery.sh ... --write"
    failed=1
  fi
  echo "$(wc -c <"$source/$picture") bytes: $line"
done <"$work/shown"
exit $failed
