#!/usr/bin/env bash
# Links of README, of the list of changes and of the guide lead to files and headings that are there, in the sources and
# as installed. README has at most 200 lines. Every page of the guide is in its index, in one chain: each names the next.
# Functions that pages of the sources name are declared in the headers, but those of older versions in CHANGELOG and the
# page on migration. Each header names pages of the guide.
#   page_links.sh sources SOURCE-FOLDER
#   page_links.sh installed PREFIX
set -euo pipefail
which=$1 root=$(realpath "$2")
case $which in
  sources) readme=$root/README.md changes=$root/.github/CHANGELOG.md guide=$root/capi/guide ;;
  installed)
    readme=$(find "$root" -path '*/doc/*/README.md' ! -path '*/guide/*')
    guide=$(dirname "$readme")/guide changes=$(dirname "$readme")/CHANGELOG.md
    ;;
esac
pages=("$guide"/*.md)
[ ${#pages[@]} -ge 16 ] || { echo "only ${#pages[@]} pages were found in $guide" && exit 1; }
failed=0
fail() {
  echo "$*"
  failed=1
}

# Clients lie beside the examples, as their pages link to them.
for client in brick_summaries.h lammps_components.c lammps_fix.py lammps_sasa.c openmm_sasa.cpp exact_sasa.f90 smooth_energy.h surface_forces.h plumed/HspSurface.cpp; do
  [ -e "$(dirname "$guide")/clients/$client" ] || fail "clients/$client is missing beside the guide"
done
# Lines of clients, as the page on other codes has them.
if [ "$which" = sources ]; then
  counts=$(grep -c . "$root"/capi/clients/*.* "$root"/capi/clients/plumed/* "$root"/capi/python/hardsphere/*.py | sed 's/.*://')
  while read -r count; do
    grep -qx "$count" <<<"$counts" || fail "inside.md: no client has $count lines"
  done < <(awk -F'|' 'NF > 6 { print $5 }' "$guide/inside.md" | grep -oE '[0-9]+')
  # How much longer examples in C are than their twins in C++, as the page on languages has it.
  twins=$(cd "$root/capi/examples" && find . -name '*.cpp' | sed 's/pp$//' | xargs cat | grep -c .)
  shorter=$(cd "$root/capi/examples" && find . -name '*.cpp' -exec cat {} + | grep -c .)
  grep -qF "$twins lines become $shorter" "$guide/languages.md" || fail "languages.md: $twins lines become $shorter"
fi
lines=$(wc -l <"$readme")
[ "$lines" -le 200 ] || fail "$readme has $lines lines; 200 are what one reads. The guide has room for the rest"

# The headings of a page, as links name them: small letters, words joined by hyphens, nothing else.
headings() {
  awk '/^```/ { code = !code } !code && /^#+ / { sub(/^#+ /, ""); print tolower($0) }' "$1" |
    sed -E -e 's/\[([^]]*)\]\([^)]*\)/\1/g' -e "s/[^[:alnum:] _-]//g" -e 's/ /-/g'
}
export LC_ALL=C.UTF-8
links=0
for page in "$readme" "$changes" "${pages[@]}"; do
  while read -r link; do
    links=$((links + 1))
    case $link in http*) continue ;; esac
    file=${link%%#*} anchor=
    [[ $link != *#* ]] || anchor=${link#*#}
    target=$page
    [ -z "$file" ] || target=$(dirname "$page")/$file
    if [ ! -e "$target" ]; then
      fail "${page#"$root"/}: no file $link"
    elif [ -n "$anchor" ] && ! grep -qxF -- "$anchor" <<<"$(headings "$target")"; then
      fail "${page#"$root"/}: no heading $link"
    fi
  done < <(awk '/^```/ { code = !code } !code' "$page" | grep -oE '\]\([^()]+\)' | sed -E 's/^\]\((.*)\)$/\1/')
done
[ $links -ge 130 ] || fail "only $links links were found"

# The chain of the pages is the order of the index, from which it begins and to which it comes back.
chain=$(grep -oE '\]\([a-z_]+\.md\) \|$' "$guide/README.md" | sed -E 's/^\]\((.*)\) \|$/\1/')
diff <(sort <<<"$chain") <(printf '%s\n' "${pages[@]##*/}" | grep -vx README.md | sort) ||
  fail "< the index of the guide, > its pages"
while read -r page && read -r next <&3; do
  named=$(sed -nE 's/^Next: \[[^]]*\]\(([^()]*)\)$/\1/p' "$guide/$page")
  [ "$named" = "$next" ] || fail "$page names \"$named\" as the next page, and the index $next"
done <<<"$chain" 3< <(sed 1d <<<"$chain" && echo README.md)

# Pages write names as `hsp_all_of_it`, `_end_of_one` after one with the same beginning, and `hsp_beginning_*`.
names=0
if [ "$which" = sources ]; then
  known=$(grep -ohE '\bhsp_[a-z0-9_]+\b' "$root"/include/*.h "$root"/include/hardsphere/*.h | sort -u)
  for page in "$readme" "$root"/lib/README.md "$root"/capi/README.md "${pages[@]}"; do
    [ "${page##*/}" != migration.md ] || continue
    while read -r name; do
      names=$((names + 1))
      case $name in
        *\*) grep -q "^${name%\*}" <<<"$known" || fail "${page#"$root"/}: no name begins with $name" ;;
        _*) grep -q "$name\$" <<<"$known" || fail "${page#"$root"/}: no name ends in $name" ;;
        *) grep -qx "$name" <<<"$known" || fail "${page#"$root"/}: no header has $name" ;;
      esac
    done < <(grep hsp_ "$page" | grep -oE '\bhsp_[a-z0-9_]+\b(\*|\.cpp)?|`_[a-z0-9_]+`' | grep -v '\.cpp$' | tr -d '`' | sort -u)
  done
  [ $names -ge 400 ] || fail "only $names names were found"

  for header in "$root"/include/hardsphere/*.h; do
    case ${header##*/} in export.h | components.h) continue ;; esac
    named=$(sed -nE 's/^ \* Guide: (.*)\.$/\1/p' "$header" | tr -d ,)
    [ -n "$named" ] || fail "${header##*/} names no page of the guide"
    for page in $named; do [ -e "$guide/$page" ] || fail "${header##*/}: the guide has no $page"; done
  done
fi
[ $failed -eq 0 ] && echo "$links links, $names names, $lines lines of README, ${#pages[@]} pages"
exit $failed
