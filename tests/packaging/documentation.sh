#!/usr/bin/env bash
# Doxygen reads the public headers without a warning, and every function of theirs is on its pages. Exit status 77: it is
# missing here.
#   documentation.sh SOURCE-FOLDER WORK-FOLDER PROGRAM
set -euo pipefail
source=$1 work=$2 program=$3
command -v doxygen >/dev/null || { echo "skipped: there is no doxygen here" && exit 77; }
rm -rf "$work"
cmake -S "$source" -B "$work" -DHSP_TESTS=OFF -DHSP_BENCH=OFF -DHSP_FUZZ=OFF -DHSP_FORTRAN=OFF -DHSP_TOOL=OFF -DHSP_DOCUMENTATION=ON >"$work.log"
# As the target does where it builds the program.
bash "$source/capi/documentation/dark_pictures.sh" "$source" "$work/documentation/pictures" "$program"
cmake --build "$work" --target hardsphere_documentation >"$work.log" 2>&1 || { grep -E 'warning|error' "$work.log" | head -n 20 && exit 1; }
here=$(cd "$(dirname "$0")" && pwd)
functions=$(bash "$here/header_functions.sh" "$source")
missing=$(comm -23 <(echo "$functions" | sort) \
  <(cat "$work"/documentation/html/*.html | grep -oE 'hsp_[a-z0-9_]+' | LC_ALL=C sort -u))
[ -z "$missing" ] || { echo "not documented:" && echo "$missing" && exit 1; }
echo "$(wc -l <<<"$functions") functions on $(find "$work/documentation/html" -name '*.html' | wc -l) pages"

# The guides: each is a page that still has its code. (page_links.sh looks at their links.)
for page in "$source"/capi/guide/*.md; do
  title=$(sed -n "1{s/^# //;s/'/\&#39;/g;p}" "$page")
  html=$(grep -lF "title>hardsphere: $title<" "$work"/documentation/html/*.html) || { echo "no page: $title" && exit 1; }
  if grep -q '^```c$' "$page" && ! grep -q 'class="fragment"' "$html"; then echo "no code: $title" && exit 1; fi
done
for picture in cavity ubiquitin ubiquitin_dark crambin_contacts_dark bond_scans window_scans; do
  [ -e "$work/documentation/html/$picture.svg" ] || { echo "the guides' picture $picture is missing" && exit 1; }
done
rm -rf "$work"
