#!/usr/bin/env bash
# The steps of .ci/version.sh for version 1.0.0, in a copy of the sources: nothing names the version that was worked on, generated
# files are those of the headers, and the kept interface is the present one. A function of the stable tier taken away, a field
# put into one of its structs and another value of a constant are refused from then on; a new function is not.
#   version.sh SOURCE-FOLDER WORK-FOLDER C-COMPILER CXX-COMPILER
# Exit status 77: a tool is missing here, or the sources are in no repository.
set -euo pipefail
source=$(realpath "$1") work=$2 cc=$3 cxx=$4
for needed in git abidw abidiff; do
  command -v $needed >/dev/null || { echo "skipped: there is no $needed here; packages git abigail-tools" && exit 77; }
done
git -C "$source" rev-parse -q --verify HEAD >/dev/null 2>&1 || { echo "skipped: the sources are in no repository" && exit 77; }
version=$(sed -nE 's/^#define HSP_VERSION_STRING "([0-9.]+)".*/\1/p' "$source/include/hardsphere/version.h")
grep -qx "## $version, not released yet" "$source/.github/CHANGELOG.md" || { echo "$version is released" && exit; }
rm -rf "$work"
mkdir -p "$work"
cd "$work"
git clone -q --shared "$source" tree
major=$((${version%%.*} + 1))
(cd tree && CXX=$cxx bash .ci/version.sh $major.0.0 2030-01-02) >log 2>&1 || { cat log && exit 1; }
left=$(git -C tree grep -nF "$version" -- ':!tests/interface' ':!*.svg' ':!fuzz' ':!bench' ':!tests/*/inputs' ':!tests/mutation/drawn' | grep -E "(^|[^0-9.])$version([^0-9.]|$)" |
  grep -v 'may change in' || true)
[ -z "$left" ] || { echo "$left" && echo "name $version still" && exit 1; }
bash tree/capi/interface/generate.sh --check
bash tree/tests/packaging/page_links.sh sources tree >log || { cat log && exit 1; }

holds() { bash tree/tests/packaging/abi.sh tree "$PWD/abi" "$cc" && bash tree/tests/packaging/binary_interface.sh "$PWD/tree" "$PWD/binary" "$cxx"; }
holds >log 2>&1 || { cat log && exit 1; }
cp -r tree/include tree/capi .
refuse() { # what was done, what is said of it
  bash tree/capi/interface/generate.sh >/dev/null
  if bash tree/tests/packaging/abi.sh tree "$PWD/abi" "$cc" >log 2>&1; then echo "declarations: $1 is not refused" && exit 1; fi
  grep -qF "$2" log || { cat log && echo "not for $2" && exit 1; }
  if [ -n "${3:-}" ]; then
    if bash tree/tests/packaging/binary_interface.sh "$PWD/tree" "$PWD/binary" "$cxx" --write >log 2>&1; then echo "binary: $1 is not refused" && exit 1; fi
    grep -qx "$3" log || { cat log && echo "not for $3" && exit 1; }
  fi
  rm -rf tree/include tree/capi
  cp -r include capi tree
}
grep -rlw hsp_areas_bytes tree/include tree/capi/shims tree/capi/interface | xargs sed -i 's/\<hsp_areas_bytes\>/hsp_areas_memory/g'
refuse "a function taken away" "hsp_areas_bytes(uint32_t n" "gone hsp_areas_bytes"
sed -i 's|^} hsp_totals;|  double more; /**< 0 */\n&|' tree/include/hardsphere/measure.h
refuse "a field more" "hsp_totals 32" "changed hsp_areas"
sed -i 's/HSP_PACKING_COINCIDENT UINT32_C(2)/HSP_PACKING_COINCIDENT UINT32_C(8)/' tree/include/hardsphere/model.h
refuse "another value" "HSP_PACKING_COINCIDENT 2"
echo "$(wc -l <tree/capi/abi/frozen.txt) lines and a binary interface are kept; three changes are refused"
