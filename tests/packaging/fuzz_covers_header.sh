#!/usr/bin/env bash
# Every function of the header is called in the interface tests, and by fuzz_arguments and the laws, which call what stands
# in their table.
#   fuzz_covers_header.sh SOURCE-FOLDER
set -euo pipefail
cd "$1"
here=$(cd "$(dirname "$0")" && pwd)
failed=0
functions=0
for function in $(bash "$here/header_functions.sh" .); do
  functions=$((functions + 1))
  if ! grep -qE "[^A-Za-z0-9_]$function\(" tests/laws/support/registry.c; then
    echo "$function is not in the table of all functions"
    failed=1
  fi
  calls="(^|[^A-Za-z0-9_])$function\("
  case $function in *_bytes | *_init) noun=${function#hsp_} calls+="|HANDLE_FUNCTIONS\(${noun%_*}\)" ;; esac
  if ! grep -rqE "$calls" --include='*.c' --include='*.cpp' tests/api; then
    echo "tests/api never calls $function"
    failed=1
  fi
done
[ $functions -gt 0 ] || failed=1
[ $failed -eq 0 ] && echo "$functions functions are fuzzed and tested"
exit $failed
