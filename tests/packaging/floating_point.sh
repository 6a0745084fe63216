#!/usr/bin/env bash
# Every function of the interface from which arithmetic of floating-point numbers can be reached sets the floating-point
# environment first (capi/shims/core/library_arithmetic.hpp): read off the code that the compiler has made.
#   floating_point.sh ARCHIVE
# Exit status 77, skipped: the archive is for another processor than x86-64, or there is no objdump.
set -euo pipefail
export LC_ALL=C
archive=$1
here=$(cd "$(dirname "$0")" && pwd)
command -v objdump >/dev/null || { echo "skipped: there is no objdump here" && exit 77; }
code=$(mktemp)
trap 'rm -f "$code"' EXIT
objdump -dr --no-show-raw-insn "$archive" >"$code"
grep -q 'file format elf64-x86-64' "$code" || { echo "skipped: not for x86-64" && exit 77; }
functions=$(awk -f "$here/floating_point.awk" "$code" "$code" | sort)
count() { grep -c " $1\$" <<<"$functions" || true; }
[ "$(count guarded)" -gt 100 ] || { echo "hardly any function sets the environment: is this read rightly?" && exit 1; }
if grep ' unguarded$' <<<"$functions"; then
  echo "calculate, and do not set the floating-point environment: capi/shims/core/library_arithmetic.hpp"
  exit 1
fi
echo "$(count guarded) functions set the environment, $(count none) have no arithmetic"
