#!/usr/bin/env bash
# The page in headless Chromium: web_page.mjs drops files, turns the molecule, points at balls and changes the screen, and
# compares what the page shows with what the native program says. Its screenshots stay in WORK-FOLDER.
#   web_page.sh SOURCE-FOLDER WORK-FOLDER HARDSPHERE.html HARDSPHERE
# Exit status 77: something is missing here.
set -euo pipefail
source=$1 work=$2 page=$3 program=$4
here=$(cd "$(dirname "$0")" && pwd)
for needed in node chromium; do
  command -v $needed >/dev/null || { echo "skipped: there is no $needed here" && exit 77; }
done
[ -e "$page" ] || { echo "skipped: the program was not compiled for WebAssembly" && exit 77; }
rm -rf "$work"
mkdir -p "$work"
bytes=$(gzip -9 -c "$page" | wc -c)
echo "the page has $(stat -c %s "$page") bytes, $bytes compressed"
[ "$bytes" -le 1500000 ]
inputs=$source/tests/program/inputs
timeout 500 node --no-warnings "$here/web_page.mjs" "$page" "$work" "$program" \
  "$source"/bench/molecules/{caffeine,ubiquitin}.pdb "$inputs/good/cage.xyzr" \
  "$source/bench/molecules/crambin.pdb+$inputs/crambin.xtc"
# Processes that the browser started may outlive it by a moment, and write.
for _ in {1..50}; do
  rm -rf "$work/profile" 2>/dev/null && break
  sleep 0.1
done
