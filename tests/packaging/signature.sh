#!/usr/bin/env bash
# A release's signature, with a key made for the test: it verifies, and does not with one changed byte of a file, of the sums
# or of the signature, with a file more or less, or with another key.
#   signature.sh SOURCE-FOLDER WORK-FOLDER
# Exit status 77: there is no minisign here.
set -euo pipefail
source=$1 work=$2
export LC_ALL=C
command -v minisign >/dev/null || { echo "skipped: there is no minisign here" && exit 77; }
rm -rf "$work"
mkdir -p "$work"
cd "$work"
for key in ours other; do minisign -G -W -f -p $key.pub -s $key.secret >/dev/null; done

fresh() {
  rm -rf release
  mkdir release
  echo "one archive" >release/hardsphere-1.tar.gz
  echo "a package" >release/hardsphere_1.deb
  HSP_RELEASE_KEY=$work/ours.secret bash "$source/.ci/release.sh" --sign release
}
verify() {
  bash "$source/.ci/release.sh" --verify "${1:-ours.pub}" release >log 2>&1
}
fresh
verify || { cat log && exit 1; }
refused=0
refuse() { # what was done
  if verify "${2:-}"; then echo "$1: verifies all the same" && exit 1; fi
  refused=$((refused + 1))
  fresh
}
printf X | dd of=release/hardsphere_1.deb bs=1 seek=3 conv=notrunc status=none
refuse "a byte of a package"
sed -i '1s/^./x/' release/SHA256SUMS
refuse "a byte of the sums"
sed -i '2{s/^\(.\{8\}\)Z/\1Y/;t;s/./Z/9}' release/SHA256SUMS.minisig  # one of 64 has this one already
refuse "a byte of the signature"
echo more >release/more
refuse "a file more"
rm release/hardsphere_1.deb
refuse "a file less"
rm release/SHA256SUMS.minisig
refuse "no signature"
refuse "another key" other.pub
echo "a signature that verifies, $refused that do not"
