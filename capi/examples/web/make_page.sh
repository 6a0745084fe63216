#!/usr/bin/env bash
# The example page as one file, which browsers open from anywhere: index.html with the scripts and the program inside.
#   make_page.sh HARDSPHERE.wasm >page.html
set -euo pipefail
program=$(realpath "$1")
cd "$(dirname "$0")"
while IFS= read -r line; do
  if [[ $line != *make_page.sh* ]]; then
    printf '%s\n' "$line"
    continue
  fi
  echo '<script type="application/gzip" id="program">'
  gzip -9 -n -c "$program" | base64
  echo '</script>'
  # Two modules in one script: without the words that join them.
  echo '<script type="module">'
  sed 's/^export //' program.mjs
  sed '/^import .*program.mjs/d' page.mjs
  echo '</script>'
done <index.html
