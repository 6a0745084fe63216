#!/usr/bin/env bash
# Every picture in README.md and the guide is what one command line there writes, byte for byte; and what the command lines of
# tests/program/pictures/digests.txt write has the size and the digest there: pictures before a dark page, and large ones. One
# of these stands beside the list as a whole, for program_draw_colours.
#   gallery.sh SOURCE-FOLDER WORK-FOLDER PROGRAM [--write]
# --write: write pictures and digests anew, where they are meant to change.
set -euo pipefail
source=$(realpath "$1") work=$2 program=$(realpath "$3") write=${4:-}
pictures=tests/program/pictures
digests=$source/$pictures/digests.txt
rm -rf "$work"
mkdir -p "$work/bin" "$work/run"
work=$(realpath "$work")
ln -s "$program" "$work/bin/hardsphere"
PATH=$work/bin:$PATH
export LC_ALL=C
cp "$source"/bench/molecules/*.pdb "$work/run"
cp "$source/bench/molecules/crambin.pdb" "$work/run/1crn.pdb"

# Lines of code, and code within the text; three blanks end a line. The same line may be in several files.
pages=("$source/README.md" "$source"/capi/guide/*.md)
{
  sed -n 's/^ *\(hardsphere [-a-z].*\)/\1/p' "${pages[@]}" | sed -E 's/ {3,}.*//'
  # shellcheck disable=SC2016 # these are Markdown's
  grep -oh '`hardsphere [^`]*`' "${pages[@]}" | tr -d '`'
  sed -n 's/^[0-9]* [0-9a-f]* \(hardsphere .*\)/\1/p' "$digests"
} | awk '!seen[$0]++' >"$work/lines"
grep -ohE "$pictures/[^)\" ]*" "${pages[@]}" | sort -u >"$work/shown"
[ "$(wc -l <"$work/shown")" -ge 9 ] || { cat "$work/shown" && echo "are all the pictures that were found" && exit 1; }
grep -oE -- '(-o|--map) [^ ]+$' "$digests" | cut -d ' ' -f 2 >"$work/digested"

failed=0
# draw NAME: into $work/run, by `line`, the one command line that writes it.
draw() {
  grep -E -- "(-o|--map|--profile|--tree) ${1//./\\.}( |\$)" "$work/lines" >"$work/line" || true
  if [ "$(wc -l <"$work/line")" -ne 1 ]; then
    echo "$1: the pages and digests.txt have $(wc -l <"$work/line") command lines that write it"
    failed=1
    return 1
  fi
  line=$(cat "$work/line")
  (cd "$work/run" && bash -c "$line" >/dev/null 2>"$work/err") || { cat "$work/err" && echo "\$ $line fails" && exit 1; }
  if [ -s "$work/err" ]; then cat "$work/err" && echo "\$ $line writes on stderr" && failed=1; fi
}

while read -r picture; do
  name=${picture##*/}
  draw "$name" || continue
  if [ "$write" = --write ]; then
    cp "$work/run/$name" "$source/$picture"
  elif ! cmp "$work/run/$name" "$source/$picture"; then
    echo "\$ $line does not write $picture; if it is meant to change: gallery.sh ... --write"
    failed=1
  fi
  echo "$(wc -c <"$source/$picture") bytes: $line"
done <"$work/shown"

sed -n '/^#/p' "$digests" >"$work/digests.txt"
while read -r name; do
  draw "$name" || continue
  echo "$(wc -c <"$work/run/$name") $(sha256sum <"$work/run/$name" | cut -d ' ' -f 1) $line" >>"$work/digests.txt"
done <"$work/digested"
if [ "$write" = --write ]; then
  cp "$work/digests.txt" "$digests"
  cp "$work/run/caffeine.svg" "$source/$pictures"
elif ! diff "$digests" "$work/digests.txt"; then
  echo "< digests.txt, > what these lines write now into $work/run. The same lines with the program of an earlier"
  echo "commit write the files to compare with. If they are meant to change: gallery.sh ... --write"
  failed=1
fi
exit $failed
