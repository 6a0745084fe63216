#!/usr/bin/env bash
# Objects compiled for wide registers define functions of their own only: of an inline function that several objects
# define the linker keeps one, which must run on every processor.
#   wide_symbols.sh FOLDER-OF-OBJECTS
set -euo pipefail
export LC_ALL=C
failed=0
n=0
while read -r object; do
  n=$((n + 1))
  shared=$(nm -C "$object" | awk '$2 ~ /^[uvVwW]$/' || true)
  if [ -n "$shared" ]; then
    echo "$object defines what other objects define as well:"
    echo "$shared" | sed 's/^/  /'
    failed=1
  fi
done < <(find "$1" -name '*_avx2.cpp.o*')
[ $n -gt 0 ] || { echo "no objects for wide registers in $1" && exit 1; }
[ $failed -eq 0 ] && echo "$n objects for wide registers"
exit $failed
