#!/usr/bin/env bash
# The bits of the results against the record of the two numerics numbers, capi/abi/numerics.txt. Exit status 77: the record
# says nothing about this machine, which is big-endian.
#   numerics.sh SOURCE-FOLDER PROGRAM [--write]
# --write makes the record anew, which a released number does not allow for its part: capi/abi/README.md.
set -euo pipefail
source=$1 program=$2 write=${3:-}
[ "$(printf '\1' | od -An -tx2 | tr -d ' ')" = 0001 ] || { echo "skipped: big-endian" && exit 77; }
record=$source/capi/abi/numerics.txt
rows=$("$program")
part() { # tier, its number's name
  echo "# Results of $1 headers, number $(awk -v name="$2" '$1 == "#define" && $2 == name { print $3 }' "$source/include/hardsphere/version.h"):" \
    "balls, results, how many, a hash of their bits"
  sed -n "s/^$1 //p" <<<"$rows"
}
results=$(part stable HSP_NUMERICS_NUMBER && part provisional HSP_PROVISIONAL_NUMERICS_NUMBER)
[ "$(wc -l <<<"$results")" -eq $(($(wc -l <<<"$rows") + 2)) ] || { echo "a row is of no tier" && exit 1; }
[ "$(wc -l <<<"$results")" -gt 100 ] || { echo "nothing was printed" && exit 1; }
if [ "$write" = --write ]; then echo "$results" >"$record"; fi
diff -u --label capi/abi/numerics.txt --label results "$record" - <<<"$results" || { echo "see capi/abi/README.md" && exit 1; }
echo "$(wc -l <<<"$rows") results"
