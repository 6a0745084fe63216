#!/usr/bin/env bash
# Draws the gallery's pictures before a dark page, which are no files of the project: by the lines of
# tests/program/pictures/digests.txt, whose bytes packaging_gallery compares.
#   dark_pictures.sh SOURCE-FOLDER FOLDER PROGRAM
set -euo pipefail
source=$(realpath "$1") program=$(realpath "$3")
mkdir -p "$2"
cd "$2"
cp "$source"/bench/molecules/*.pdb .
cp crambin.pdb 1crn.pdb
sed -n 's/^[0-9]* [0-9a-f]* hardsphere \(.*_dark\.svg\)$/\1/p' "$source/tests/program/pictures/digests.txt" |
  while read -ra words; do "$program" "${words[@]}" >/dev/null; done
rm ./*.pdb
