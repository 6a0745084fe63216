#!/usr/bin/env bash
# Every file of lib/ has a test of its name, tests/unit/<room>/<file>_test.cpp, or a reason in without_test.txt.
#   every_file_has_a_test.sh SOURCE-FOLDER
set -euo pipefail
cd "$1"
list=tests/unit/without_test.txt
failed=0

complain() {
  echo "$1"
  failed=1
}

declare -A reason
while read -r unit why; do
  case $unit in '' | '#'*) continue ;; esac
  [ -n "$why" ] || complain "$list: $unit without a reason"
  reason[$unit]=$why
done <"$list"

units=$(find lib -name '*.hpp' -o -name '*.cpp' | sed -E 's,^lib/[a-z]*/,,; s,(\.kernel)?\.[ch]pp$,,' | sort -u)
for unit in $units; do
  if [ -e "tests/unit/${unit}_test.cpp" ]; then
    [ -z "${reason[$unit]+known}" ] || complain "$list: $unit has a test by now"
  elif [ -z "${reason[$unit]+known}" ]; then
    complain "$unit: no tests/unit/${unit}_test.cpp"
  fi
done
for unit in "${!reason[@]}"; do
  grep -qx "$unit" <<<"$units" || complain "$list: lib has no $unit"
done
[ $failed -eq 0 ] && echo "$(wc -w <<<"$units") files, ${#reason[@]} of them without a test of their own"
exit $failed
