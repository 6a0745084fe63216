#!/usr/bin/env bash
# Evidence for the core: runs the tests that show each promise of requirements.txt, and says how many, and how many checks
# they count.
#   run.sh [--write] [NAME...]   all rows, or those of these names; --write puts them into lib/EVIDENCE.md
# Builds what it needs in build/dev.
set -euo pipefail
cd "$(dirname "$0")/../.."
export LC_ALL=C
write=no
if [ "${1:-}" = --write ]; then write=yes && shift; fi
cmake --preset dev >/dev/null
cmake --build --preset dev >/dev/null
rows=$(grep -v '^#' tests/evidence/requirements.txt)
failed=no
table=""
now="$(date -u +%Y-%m-%d) at $(git rev-parse --short HEAD)"
while IFS='|' read -r name promise how tests; do
  name=${name// /}
  tests=${tests# }
  if [ $# -gt 0 ] && [[ " $* " != *" $name "* ]]; then
    table+=$(grep "^| $name |" lib/EVIDENCE.md || true)$'\n'
    continue
  fi
  log=$(mktemp)
  start=$(date +%s)
  status="holds"
  ctest --test-dir build/dev -V -j2 -R "$tests" >"$log" 2>&1 || { status="FAILS" && failed=yes; }
  seconds=$(($(date +%s) - start))
  read -r passed skipped checks < <(awk '
    /\*\*\*Skipped/ { ++skipped }
    / Passed +[0-9.]+ sec/ { ++passed }
    match($0, /[0-9]+ checks, /) { split(substr($0, RSTART, RLENGTH), word, " "); checks += word[1] }
    match($0, /\[  PASSED  \] [0-9]+ test/) { split(substr($0, RSTART, RLENGTH), word, " "); checks += word[4] }
    END { print passed + 0, skipped + 0, checks + 0 }' "$log")
  rm -f "$log"
  if [ "$passed" -eq 0 ]; then status="FAILS" && failed=yes; fi
  row="| $name |$promise|$how| $passed tests$([ "$skipped" -eq 0 ] || echo ", $skipped left out here")$([ "$checks" -eq 0 ] || echo ", $checks cases") | $seconds s | $now | $status |"
  echo "$row"
  table+=$row$'\n'
done <<<"$rows"
if [ "$write" = yes ]; then
  {
    sed '/^| row /,$d' lib/EVIDENCE.md
    printf '| row | promise | how it is known | shown by | time | run | |\n|---|---|---|---|---|---|---|\n%s\n' "$table"
    echo "Compiled by $("${CXX:-g++}" --version | head -n 1) for $(uname -m), run on $(nproc) cores."
  } >lib/EVIDENCE.now
  mv lib/EVIDENCE.now lib/EVIDENCE.md
fi
[ "$failed" = no ]
