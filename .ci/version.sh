#!/usr/bin/env bash
# Gives the tree the number of a version that is about to be released, which is then all that its commit changes:
#   bash .ci/version.sh VERSION [DAY]     DAY as 2026-11-28; without it today
#   git commit -am "version VERSION"      and what CONTRIBUTING.md says under Release
# The version that is worked on gets the number and the day wherever it is named. From 1.0 on the interface of the stable
# tier is kept as it then is: the binary one (capi/abi/VERSION.abi, of what is before it nothing), and declarations, constants
# and structs (capi/abi/frozen.txt, to which lines come and from which none goes). ABI and numerics numbers stay: they were
# raised with the changes that asked for it. Needs abigail-tools, python3-pycparser and g++, and installs nothing.
set -euo pipefail
cd "$(dirname "$0")/.."
[[ ${1:-} =~ ^([0-9]+)\.([0-9]+)\.([0-9]+)$ ]] || { sed -n '2,/^[^#]/s/^# \{0,1\}//p' .ci/version.sh && exit 2; }
version=$1 major=${BASH_REMATCH[1]} minor=${BASH_REMATCH[2]} patch=${BASH_REMATCH[3]} day=${2:-$(date -u +%Y-%m-%d)}
old=$(sed -nE 's/^#define HSP_VERSION_STRING "([0-9.]+)".*/\1/p' include/hardsphere/version.h)
grep -qx "## $old, not released yet" .github/CHANGELOG.md || { echo "$old is released" >&2 && exit 1; }
short=${version%.*} old_short=${old%.*}

sed -i -E "s/^(#define HSP_VERSION_MAJOR) [0-9]+ /\1 $major /; s/^(#define HSP_VERSION_MINOR) [0-9]+ /\1 $minor /
  s/^(#define HSP_VERSION_PATCH) [0-9]+ /\1 $patch /; s/^(#define HSP_VERSION_STRING) \"$old\"/\1 \"$version\"/" include/hardsphere/version.h
sed -i "s/^## $old, not released yet$/## $version, $day/; s/^\(| [0-9.]* | \)$old |$/\1$version |/" .github/CHANGELOG.md
sed -i "s/ $old / $version /" capi/abi/since.txt
sed -i -E "s/(version = )\{[0-9.]+\}/\1{$version}/" README.md
sed -i "s/\<$old\>/$version/" tests/program/transcripts/usage.txt
sed -i -E "s/(find_package\(hardsphere) [0-9.]+ /\1 $short /" capi/guide/building.md tests/packaging/consumers/find_package/CMakeLists.txt
sed -i -E "s/^(## From [0-9.]+ to )$old_short$/\1$short/; s/^(\| [0-9.]+ \| )$old_short \|$/\1$short |/; s/Version $old_short has/Version $short has/" capi/guide/migration.md
link=-to-${old_short/./}
{ git grep -lz -- "#from-[0-9]*$link" '*.md' || true; } | xargs -0r sed -i -E "s/(#from-[0-9]+)$link/\1-to-${short/./}/"
git mv "fuzz/record/$old.csv" "fuzz/record/$version.csv"
bash capi/interface/generate.sh

if [ "$major" -gt 0 ]; then
  git rm -q --ignore-unmatch 'capi/abi/*.abi'
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
  bash tests/packaging/binary_interface.sh "$PWD" "$work" "${CXX:-g++}" --freeze
  sed -i -E "s/^\| \`[0-9.]+\.abi\` \| the binary interface of the release [0-9.]+, commit [^,]*,/| \`$version.abi\` | the binary interface of the release $version, commit \"version $version\",/
    s/^(\| \`differences.txt\`.*) since that release/\1 since that release/" capi/abi/README.md
  # Sizes that may grow are left out.
  for file in functions constants structs; do awk '/^#/ { ++part; next } part == 1' capi/abi/$file.txt; done |
    awk '{ row[NR] = $0 } match($0, /\.struct_size /) { grows[substr($0, 1, RSTART - 1)] = 1 }
      END { for (k = 1; k <= NR; ++k) if (!(split(row[k], word, " ") == 2 && word[1] in grows)) print row[k] }' |
    grep -vE '^HSP_([A-Z_]+_BYTES\(|MAX_BALLS )|\.(reserved|unused) ' | LC_ALL=C sort >capi/abi/frozen.txt
fi
git add -A capi/abi
git status --short
echo "now: git commit -am \"version $version\""
