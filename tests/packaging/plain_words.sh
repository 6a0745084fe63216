#!/usr/bin/env bash
# Comments and pages are in plain words: none of the phrases of plain_words.txt, and no sentence begins with What
# or Who and asks nothing.
#   plain_words.sh SOURCE-FOLDER
set -euo pipefail
here=$(realpath "$(dirname "$0")")
cd "$1"
find lib capi include tests bench fuzz .github .ci ./*.md -type f \
  \( -name '*.[ch]' -o -name '*.[ch]pp' -o -name '*.f90' -o -name '*.md' -o -name '*.sh' -o -name '*.cmake' -o -name '*.awk' \
  -o -name '*.py' -o -name CMakeLists.txt \) | sed 's,^\./,,' | sort | xargs awk -f "$here/plain_words.awk" "$here/plain_words.txt"
