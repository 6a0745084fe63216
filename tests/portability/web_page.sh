#!/usr/bin/env bash
# The example page in headless Chromium: web_page.mjs chooses files, turns the molecule and points at balls, and compares
# what the page shows with what the native program says.
#   web_page.sh SOURCE-FOLDER WORK-FOLDER HARDSPHERE.wasm HARDSPHERE
# Exit status 77: something is missing here.
set -euo pipefail
source=$1 work=$2 wasm=$3 program=$4
here=$(cd "$(dirname "$0")" && pwd)
for needed in node chromium; do
  command -v $needed >/dev/null || { echo "skipped: there is no $needed here" && exit 77; }
done
[ -e "$wasm" ] || { echo "skipped: the program was not compiled for WebAssembly" && exit 77; }
rm -rf "$work"
mkdir -p "$work"
bash "$source/capi/examples/web/make_page.sh" "$wasm" >"$work/page.html"
echo "the page has $(stat -c %s "$work/page.html") bytes"
timeout 110 node --no-warnings "$here/web_page.mjs" "$work/page.html" "$work/profile" "$program" \
  "$source"/bench/molecules/{caffeine,crambin}.pdb "$source/tests/program/inputs/good/cage.xyzr"
# Processes that the browser started may outlive it by a moment, and write.
for _ in {1..50}; do
  rm -rf "$work/profile" 2>/dev/null && break
  sleep 0.1
done
