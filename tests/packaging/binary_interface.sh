#!/usr/bin/env bash
# The binary interface of the core against that of the last release, capi/abi/<version>.abi, by libabigail. Functions that are
# gone, changed or new are those of capi/abi/differences.txt, and the changelog or the migration page names each. From 1.0
# on none may be gone or changed.
#   binary_interface.sh SOURCE-FOLDER WORK-FOLDER CXX-COMPILER [--write or --freeze]
# --write makes the list anew; --freeze keeps the interface as that of the version in the header, for .ci/version.sh. Exit status 77: there is no abidiff (package abigail-tools) or no Python, or the machine is
# not x86-64.
set -euo pipefail
source=$1 work=$2 cxx=$3 write=${4:-}
export LC_ALL=C
for needed in abidiff python3; do
  command -v $needed >/dev/null || { echo "skipped: there is no $needed here" && exit 77; }
done
[ "$("$cxx" -dumpmachine | cut -d- -f1)" = x86_64 ] || { echo "skipped: not x86-64" && exit 77; }
rm -rf "$work"
mkdir -p "$work"
cd "$work"
list=$source/capi/abi/differences.txt
release=$(find "$source/capi/abi" -name '*.abi' -printf '%f\n' | sort -V | tail -n 1)
python3 "$source/.ci/one_file.py" one
"$cxx" -std=c++20 -g -O0 -fPIC -fvisibility=hidden -fno-exceptions -DHSP_BUILD_SHARED=1 -c one/hardsphere.cpp -o core.o
"$cxx" -shared core.o -o libcore.so
abidw --exported-interfaces-only --headers-dir one --drop-private-types --no-corpus-path --no-comp-dir-path --no-show-locs \
  libcore.so >core.abi
if [ "$write" = --freeze ]; then
  release=$(sed -nE 's/^#define HSP_VERSION_STRING "([0-9.]+)".*/\1/p' "$source/include/hardsphere/version.h").abi
  cp core.abi "$source/capi/abi/$release"
fi
# Its status has a bit for a difference, and others for errors and for wrong usage.
status=0
abidiff "$source/capi/abi/$release" core.abi >differences || status=$?
[ $((status & 3)) -eq 0 ] || { cat differences && exit 1; }
awk 'NR == FNR { if ($1 != "#") known[$1] = 1; next }
  /^  \[D\]/ { kind = "gone" } /^  \[C\]/ { kind = "changed" } /^  \[A\]/ { kind = "new" }
  /^  \[/ {
    match($0, /hsp_[a-z_]+\(/)
    name = substr($0, RSTART, RLENGTH - 1)
    if (RSTART > 0 && (kind != "gone" || !(name in known))) print kind, name # others are provisional, or of the standard
  }' "$source/capi/abi/since.txt" differences | sort >found
{ echo "# The core's binary interface against that of ${release%.abi}, by abidiff" && cat found; } >now
if [ -n "$write" ]; then cp now "$list"; fi
diff -u "$list" now || { cat differences && exit 1; }
case $release in
  0.*) ;;
  *) if grep -E '^(gone|changed) ' found; then echo "what $release promised" && exit 1; fi ;;
esac
missing=0
while read -r kind name; do
  grep -qw "$name" "$source/.github/CHANGELOG.md" "$source/capi/guide/migration.md" ||
    { echo "$kind $name: neither in the changelog nor in the migration page" && missing=1; }
done <found
[ "$missing" -eq 0 ] || exit 1
echo "$(wc -l <found) differences from $release, all in the changelog or the migration page"
