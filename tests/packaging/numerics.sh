#!/usr/bin/env bash
# The bits of the results against the record of the numerics version, capi/abi/numerics.txt. Exit status 77: the record
# says nothing about this machine, which is big-endian.
#   numerics.sh SOURCE-FOLDER PROGRAM [--write]
# --write makes the record anew, which a released numerics version does not allow: capi/abi/README.md.
set -euo pipefail
source=$1 program=$2 write=${3:-}
[ "$(printf '\1' | od -An -tx2 | tr -d ' ')" = 0001 ] || { echo "skipped: big-endian" && exit 77; }
record=$source/capi/abi/numerics.txt
results=$(
  sed -nE 's/^#define HSP_NUMERICS_NUMBER ([0-9]+).*/# Numerics version \1: balls, results, how many, a hash of their bits/p' \
    "$source/include/hardsphere/version.h"
  "$program"
)
[ "$(wc -l <<<"$results")" -gt 100 ] || { echo "nothing was printed" && exit 1; }
if [ "$write" = --write ]; then echo "$results" >"$record"; fi
diff -u --label capi/abi/numerics.txt --label results "$record" - <<<"$results" || { echo "see capi/abi/README.md" && exit 1; }
echo "$(($(wc -l <<<"$results") - 1)) results"
