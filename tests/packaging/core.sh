#!/usr/bin/env bash
# The core is what the functions of the stable headers reach: the shims that define them, what these include, and with
# each header the source of its name. lib/core_files.txt lists it, and the table of lib/CORE.md has its size. A file
# that joins the core, or a number that grows, is a commit of its own. Files of more than 200 lines open with a drawing or
# an example: rows of their first comment that are set apart by blanks.
#   core.sh SOURCE-FOLDER           compares list and numbers with the code
#   core.sh SOURCE-FOLDER --write   writes both
set -euo pipefail
export LC_ALL=C
cd "$1"
list=lib/core_files.txt page=lib/CORE.md
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

stable() { sed -n 's/ [0-9.]* stable$//p' capi/abi/since.txt; }
stable >"$work/functions"
# A shim defines a function where the name begins a declarator in the first column, and those of a handle's life by a row.
{
  grep -noE '^[a-z][a-z0-9_ ]* [*]?hsp_[a-z0-9_]+\(' capi/shims/*/*.cpp | sed -E 's/^([^:]*):.*[ *](hsp_[a-z0-9_]+)\($/\2 \1/'
  sed -nE 's/^HSP_HANDLE_(MEMORY|BY_BALLS)\((hsp_[a-z]+)\);$/\2_bytes \2_init \2_limits_init/p; T; F' capi/shims/*/*.cpp |
    awk 'NF == 3 { split($0, name, " "); next } { for (k = 1; k <= 3; ++k) print name[k], $0 }'
} | sort -u >"$work/defined"
join <(sort "$work/functions") "$work/defined" >"$work/shims"
[ "$(cut -d ' ' -f 1 "$work/shims" | sort -u | wc -l)" -eq "$(wc -l <"$work/functions")" ] ||
  { echo "of these stable functions no shim is found:" && join -v 1 <(sort "$work/functions") "$work/defined" && exit 1; }

{
  find lib -name '*.?pp'
  find capi/shims -name '*.?pp'
} | sort >"$work/all"
{ xargs grep -HE '^ *# *include "' <"$work/all" || true; } | sed -E 's/^([^:]*):.*"(.*)"$/\1 \2/' >"$work/includes"
awk '
  FILENAME ~ /all$/ {
    name = $1
    sub(/^lib\/[a-z]+\/|^capi\/shims\/[a-z]+\//, "", name)
    path[name] = $1
    next
  }
  FILENAME ~ /includes$/ { of[$1] = of[$1] " " $2; next }
  { reach($2) }
  function reach(file) {
    if (file in reached) return
    reached[file] = 1
    waiting[++last] = file
  }
  END {
    while (first < last) {
      file = waiting[++first]
      count = split(of[file], included, " ")
      for (k = 1; k <= count; ++k) {
        if (!(included[k] in path)) continue
        reach(path[included[k]])
        stem = included[k]
        sub(/\.hpp$/, "", stem)
        if ((stem ".cpp") in path) reach(path[stem ".cpp"])
        if ((stem ".kernel.cpp") in path) reach(path[stem ".kernel.cpp"])
      }
    }
    for (file in reached) print file
  }' "$work/all" "$work/includes" "$work/shims" | sort >"$work/core"

# The numbers of a list of files: files, lines, lines of code without comments and blanks, rows of comments alone for 100
# of code and comments, and the lines of the longest function.
numbers() {
  xargs awk '
    FNR == 1 { ++files; in_comment = 0; begun = 0 }
    { ++lines }
    /^[ ]*$/ { next }
    in_comment || /^[ ]*\/[\/*]/ { ++comments; in_comment = (in_comment || /^[ ]*\/\*/) && !/\*\//; next }
    { ++code }
    # A function begins where a row ends with a brace behind a parenthesis and ends with a brace as far indented.
    !begun && /^(  )?[A-Za-z~].*\(/ && !/[;}]$/ && !/^ *(namespace|class|struct|union|enum|if|for|while|switch|return|else|do)[ (]/ {
      indent = match($0, /[^ ]/) - 1
      begun = FNR
    }
    begun && /;$/ && FNR == begun { begun = 0 }
    begun && $0 == sprintf("%*s}", indent, "") {
      if (FNR - begun + 1 > longest) longest = FNR - begun + 1
      begun = 0
    }
    END { print files, lines, code, int(100 * comments / (code + comments) + 0.5), longest }'
}
grep '^lib/' "$work/core" >"$work/lib" || true
grep '^capi/' "$work/core" >"$work/of_capi" || true
read -r files lines code share longest <<<"$(numbers <"$work/lib")"
read -r shims shim_lines shim_code _ _ <<<"$(numbers <"$work/of_capi")"
# A mistake's name, its file and the test that notices it.
awk 'NR == FNR { core[$1] = 1; next } /^[a-z][0-9]+ [^ ]+( [a-z0-9_]+)?$/ && $2 in core' "$work/core" \
  tests/mutation/mutations.txt >"$work/mutants"
mutants=$(wc -l <"$work/mutants")
noticed=$(awk 'NF == 3 && $3 != "survived"' "$work/mutants" | wc -l)
rows() {
  cat <<EOF
| functions of the interface | $(wc -l <"$work/functions") |
| files of \`lib\` | $files |
| lines of them | $lines |
| lines of code, without comments and blanks | $code |
| comments, of 100 rows of code and comments | $share |
| lines of the longest function | $longest |
| shims: files, lines, lines of code | $shims, $shim_lines, $shim_code |
| planted mistakes in these files, and of these noticed | $mutants, $noticed |
EOF
}
rows >"$work/rows"

if [ "${2:-}" = --write ]; then
  cp "$work/core" "$list"
  awk -v rows="$(cat "$work/rows")" '
    /^\| functions of the interface / { print rows; skip = 1 }
    skip && !/^\|/ { skip = 0 }
    !skip' "$page" >"$work/page"
  cp "$work/page" "$page"
fi
failed=0
diff "$list" "$work/core" >"$work/difference" || {
  echo "the core is not what $list says (< there, > in the code):"
  cat "$work/difference"
  failed=1
}
unopened=$(xargs awk '
  FNR == 1 { opening = 1; apart = 0 }
  opening && /^\/\/  / { apart = 1 }
  opening && !/^\/\// { opening = 0 }
  FNR == 201 && !apart { print FILENAME }' <"$work/core")
[ -z "$unopened" ] || { echo "no drawing or example opens: $unopened" && failed=1; }
outside=$(grep -vE '^(lib/ground/(core|exact|lanes)|lib/balls/model|lib/union/(sphere|boundary|topology|measure|contacts)|capi/shims/core)/' "$work/core" || true)
[ -z "$outside" ] || { echo "the core reaches out of its nine rooms: $outside" && failed=1; }
# Mistakes are planted and noticed by and by: the page says no more than there are.
read -r said_mutants said_noticed <<<"$(sed -nE 's/^\| planted mistakes .* \| ([0-9]+), ([0-9]+) \|$/\1 \2/p' "$page")"
[ "${said_mutants:-0}" -gt 0 ] && [ "$said_mutants" -le "$mutants" ] && [ "${said_noticed:-0}" -le "$noticed" ] ||
  { echo "$page has $said_mutants planted mistakes and $said_noticed noticed ones, there are $mutants and $noticed" && failed=1; }
while IFS= read -r row; do
  case $row in '| planted '*) continue ;; esac
  grep -qxF -- "$row" "$page" || { echo "$page does not have: $row" && failed=1; }
done <"$work/rows"
[ $failed -eq 0 ] && echo "$files files of lib and $shims of the interface are the core, as $list and $page say"
exit $failed
