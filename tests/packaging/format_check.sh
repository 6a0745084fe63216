#!/usr/bin/env bash
# Every C and C++ file is formatted as .clang-format says, and no line, comments included, is longer than 120 columns.
# Exit status 77: the tool is missing.
#   format_check.sh SOURCE-FOLDER
set -euo pipefail
cd "$1"
tool=$(command -v clang-format-14 || command -v clang-format || true)
if [ -z "$tool" ] || ! "$tool" --version | grep -q 'version 14\.'; then
  echo "skipped: clang-format 14 is not installed"
  exit 77
fi
files=$(find lib include capi tests bench fuzz -name '*.c' -o -name '*.h' -o -name '*.cpp' -o -name '*.hpp' | sort)
echo "$(wc -l <<<"$files") files"
# clang-format leaves comments as they are (ReflowComments). Characters count, not bytes.
long=$(xargs grep -nP '^.{121}' <<<"$files" | cut -c 1-160 || true)
[ -z "$long" ] || { echo "longer than 120 columns:" && echo "$long" && exit 1; }
xargs -P 2 -n 20 "$tool" --style=file --dry-run -Werror <<<"$files"
