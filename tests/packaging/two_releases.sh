#!/usr/bin/env bash
# A release made twice of one commit is the same, byte for byte: the second time in another folder, time zone and language, by
# another user's name, with another umask and number of jobs. A changed byte is noticed.
#   two_releases.sh SOURCE-FOLDER WORK-FOLDER [PARTS [CHROOT]]
# PARTS are those of .ci/release.sh; without them, what takes no compiler is made. With a bare Debian in the folder CHROOT the
# packages are built in there the first time, and on this machine the second time. The first release is left in
# WORK-FOLDER/release. Exit status 77: a tool is missing here, or the sources are in no repository.
set -euo pipefail
source=$(realpath "$1") work=$2 parts=${3:-} chroot=${4:-}
skip() {
  echo "skipped: $*"
  exit 77
}
for needed in git python3 dpkg-source; do
  command -v $needed >/dev/null || skip "there is no $needed here; packages git python3 dpkg-dev"
done
git -C "$source" rev-parse -q --verify HEAD >/dev/null 2>&1 || skip "the sources are in no repository"
mkdir -p "$work"
work=$(realpath "$work") other=$(realpath "$work")/another/and/longer/path
rm -rf "$work/release" "$work/another"
release() { # sources, folder, chroot
  HSP_RELEASE_PARTS=$parts bash "$1/.ci/release.sh" "$2" ${3:+"$3"} >"$work/log" 2>&1 || { tail -n 40 "$work/log" && exit 1; }
}
(
  export TZ=UTC LC_ALL=C CMAKE_BUILD_PARALLEL_LEVEL=1
  umask 022
  release "$source" "$work/release" "$chroot"
)
mkdir -p "$other/home" "$other/temporary"
git clone -q --shared "$source" "$other/sources"
(
  LC_ALL=$(locale -a 2>/dev/null | grep -vE '^(C|POSIX)$' | tail -n 1)
  export LC_ALL=${LC_ALL:-C} LANGUAGE=tr TZ=Pacific/Chatham USER=somebody LOGNAME=somebody HOME=$other/home TMPDIR=$other/temporary
  export CMAKE_BUILD_PARALLEL_LEVEL=2 DEB_BUILD_OPTIONS="${DEB_BUILD_OPTIONS:-} parallel=2"
  umask 077
  release "$other/sources" "$other/release" ""
)
same() { diff -r "$work/release" "$other/release"; }
same || { echo "two releases of one commit differ" && exit 1; }
# Of any file its middle byte.
for file in "$other"/release/*; do
  cp "$file" "$work/kept"
  middle=$(($(stat -c %s "$file") / 2))
  other_byte=$((($(od -An -tu1 -j "$middle" -N 1 "$file") + 1) % 256))
  # shellcheck disable=SC2059 # the byte is the format
  printf "\\$(printf %03o $other_byte)" | dd of="$file" bs=1 seek="$middle" conv=notrunc status=none
  if same >/dev/null; then echo "another byte of ${file##*/} is not noticed" && exit 1; fi
  mv "$work/kept" "$file"
done
rm -rf "$work/another"
echo "$(wc -l <"$work/release/SHA256SUMS") files of two releases are the same"
