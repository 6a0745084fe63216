#!/usr/bin/env bash
# The page as one file, which browsers open from anywhere: index.html with the scripts, the program and a first molecule
# inside.
#   make_page.sh HARDSPHERE.wasm >page.html
set -euo pipefail
program=$(realpath "$1")
cd "$(dirname "$0")"
packed() { # id, file
  echo "<script type=\"application/gzip\" id=\"$1\">"
  gzip -9 -n -c "$2" | base64
  echo '</script>'
}
while IFS= read -r line; do
  if [[ $line != *make_page.sh* ]]; then
    printf '%s\n' "$line"
    continue
  fi
  packed first ../../../bench/molecules/crambin.pdb
  packed program "$program"
  # Two modules in one script: without the words that join them.
  echo '<script type="text/plain" id="worker">'
  sed 's/^export //' program.mjs
  sed '/^import .*program.mjs/d' worker.mjs
  echo '</script>'
  echo '<script type="module" nonce="page">'
  cat page.mjs
  echo '</script>'
done <index.html
