#!/usr/bin/env bash
# Every function of the header is called in the fuzz harnesses and in the interface tests, and with the heap trapped.
#   fuzz_covers_header.sh SOURCE-FOLDER
set -euo pipefail
cd "$1"
here=$(cd "$(dirname "$0")" && pwd)
failed=0
functions=0
for function in $(bash "$here/header_functions.sh" .); do
  functions=$((functions + 1))
  # Harnesses call some functions by way of the kinds of handles in tests/support, where these are members.
  if ! grep -rqE "(^|[^A-Za-z0-9_])$function(\(|;)" --include='*.cpp' --include='*.hpp' fuzz tests/support; then
    echo "fuzz never calls $function"
    failed=1
  fi
  if ! grep -rqE "(^|[^A-Za-z0-9_])$function\(" --include='*.c' --include='*.cpp' tests/api; then
    echo "tests/api never calls $function"
    failed=1
  fi
  if ! grep -qE "(^|[^A-Za-z0-9_])$function\(" tests/api/*malloc_trap_test.c; then
    echo "nobody calls $function with the heap trapped"
    failed=1
  fi
done
[ $functions -gt 0 ] || failed=1
[ $failed -eq 0 ] && echo "$functions functions are fuzzed and tested"
exit $failed
