#!/usr/bin/env bash
# The error bounds of the core's filters, proved by Gappa from what the code computes. Each script of this folder says
# what it proves. It takes constants, or whole expressions, from the source: a bound that changes there is proved anew.
#   bounds.sh SOURCE-FOLDER [SCRIPT...]
# Lines of a script, which the preprocessor of C expands:
#   //constant NAME FILE REGEX   NAME is the first group of the regular expression, which fits one line of the file
#   //source NAME FILE START     NAME is what the file has from START, or from B in `A ... B`, to the next semicolon
#   //run NAME OPTIONS           a run with these options of the preprocessor; without such lines there is one
# A bound is proved if Gappa finds that the error is no larger; and it is TIGHT if half of it would be refused.
set -euo pipefail
export LC_ALL=C
source=$1
shift
here=$(cd "$(dirname "$0")" && pwd)
for program in gappa cpp; do
  command -v $program >/dev/null || { echo "no $program" && exit 77; }
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
[ $# -gt 0 ] || set -- "$here"/*_bounds.gappa

definitions() {  # of a script, for the preprocessor
  local kind name file pattern value
  while read -r kind name file pattern; do
    if [ "$kind" = //constant ]; then
      value=$(sed -nE "s|.*$pattern.*|\1|p" "$source/$file")
    else
      value=$(awk -v starts="$pattern" '
        BEGIN { count = split(starts, start, / \.\.\. /) }
        !on && (at = index($0, start[found + 1])) { $0 = substr($0, at + length(start[++found])); on = found == count }
        on { end = index($0, ";"); printf "%s ", end ? substr($0, 1, end - 1) : $0; if (end) exit }' "$source/$file")
    fi
    if [ -z "$value" ] || [[ $value == *$'\n'* ]]; then echo "$file has not one '$pattern'" >&2 && return 1; fi
    # Suffixes of floats go.
    echo "#define $name ($(sed -E 's/([0-9])F\b/\1/g' <<<"$value"))"
  done < <(grep -E '^//(constant|source) ' "$1")
}

failed=0
printf '%-28s %-6s %s\n' script part 'of the bound, by Gappa'
for script in "$@"; do
  name=$(basename "$script" .gappa)
  definitions "$script" >"$work/definitions.h"
  while read -r _ run options; do
    # shellcheck disable=SC2086
    cpp -P -I "$here" -include "$work/definitions.h" $options -x c "$script" >"$work/script"
    gappa "$work/script" >"$work/log" 2>&1 || { cat "$work/log" && failed=1; }
    ! grep -E 'Warning|pointless' "$work/log" || failed=1  # pointless: hypotheses contradict each other
    awk -v script="${name%_bounds}${run:+ $run}" -v asked="$(grep -o ' in ?' "$work/script" | wc -l)" '
      function number(text, parts) { return split(text, parts, /b/) == 2 ? parts[1] * 2 ^ parts[2] : text }
      / in \[.*\]$/ {
        gsub(/ \{[^}]*\}/, "")
        at = index($0, " in [")
        error = substr($0, 3, at - 3)
        split(substr($0, at + 5, length($0) - at - 5), ends, /, /)
        low = number(ends[1])
        high = number(ends[2])
        part = high > -low ? high : -low
        tight = index($0, "1 - 1b-20")
        verdict = part > 1 ? "NOT PROVED" : tight && part <= 0.5 ? "NOT TIGHT" : ""
        printf "%-28s %.3f  %s %s\n", script, part, verdict, error
        wrong += verdict != ""; ++goals
      }
      END { exit wrong > 0 || goals != asked || goals == 0 }' "$work/log" || failed=1
  done < <(grep '^//run ' "$script" || echo //run)
done
exit $failed
