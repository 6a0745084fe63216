#!/usr/bin/env bash
# Links of README, of the list of changes and of the guide lead to files and headings that are there, in the sources and
# as installed. README has at most 200 lines. Every page of the guide is in its index, in one chain: each names the next.
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
    elif [ -n "$anchor" ] && ! headings "$target" | grep -qxF -- "$anchor"; then
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
[ $failed -eq 0 ] && echo "$links links, $lines lines of README, ${#pages[@]} pages"
exit $failed
