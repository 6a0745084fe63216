#!/usr/bin/env bash
# A release (.ci/release.sh), whole: its packages are built in a bare Debian and on this machine, with the same bytes
# (two_releases.sh). In another bare Debian they are installed: the program runs, programs in C and Fortran link the library,
# Python finds it, and all of it can be taken away again. The programs that need no library tell crambin's area.
#   release.sh SOURCE-FOLDER WORK-FOLDER
# Exit status 77: it needs root, debootstrap, the tools for packages, and the archive of Debian that apt uses.
set -euo pipefail
source=$(realpath "$1") work=$2
skip() {
  echo "skipped: $*"
  exit 77
}
[ "$(id -u)" -eq 0 ] || skip "only root can make a bare Debian"
for needed in debootstrap dpkg-buildpackage dh dh_python3 lintian ninja aarch64-linux-gnu-g++ x86_64-w64-mingw32-g++ clang++-14 node; do
  command -v $needed >/dev/null || skip "there is no $needed here; .ci/install.sh has the packages of long tests"
done
read -r archive suite < <(apt-get indextargets --format '$(REPO_URI) $(CODENAME)' 'Created-By: Packages' | grep -vE 'updates|security' || true) ||
  skip "apt knows no archive"
run() {
  "$@" >>"$work/log" 2>&1 || { tail -n 40 "$work/log" && exit 1; }
}
rm -rf "$work"
mkdir -p "$work"
debootstrap --variant=minbase "$suite" "$work/builder" "$archive" >"$work/log" 2>&1 ||
  { tail -n 3 "$work/log" && skip "debootstrap cannot make a bare Debian here"; }
cp /etc/resolv.conf "$work/builder/etc/resolv.conf" 2>/dev/null || true
# The settings of apt here, about proxies and the like.
cp -r /etc/apt/apt.conf.d/. "$work/builder/etc/apt/apt.conf.d/"
cp -a "$work/builder" "$work/user"
bash "$source/tests/packaging/two_releases.sh" "$source" "$work" "debian arm64 linux windows wasm" "$work/builder"
rm -rf "$work/builder"
release=$work/release

# Programs alone, within their sizes.
cd "$work"
for packed in "$release"/hardsphere-*-{linux,wasm32}*.tar.gz; do tar -xf "$packed"; done
python3 -m zipfile -e "$release"/hardsphere-*-windows-*.zip .
[ "$(stat -c %s "$release"/hardsphere-[0-9]*.html)" -le 1500000 ]
[ "$(stat -c %s hardsphere-*-linux-*/bin/hardsphere)" -le 3100000 ] || { ls -l hardsphere-*-linux-*/bin && exit 1; }
! ldd hardsphere-*-linux-*/bin/hardsphere 2>/dev/null || exit 1
cp "$source/bench/molecules/crambin.pdb" .
for command in hardsphere-*-linux-*/bin/hardsphere "node --no-warnings hardsphere-*-wasm32/run.mjs hardsphere-*-wasm32/bin/hardsphere.wasm" \
  "/usr/lib/wine/wine64 hardsphere-*-windows-*/bin/hardsphere.exe"; do
  [[ $command != */wine64* || -x /usr/lib/wine/wine64 ]] || continue
  # shellcheck disable=SC2086 # several words
  WINEPREFIX=$PWD/prefix WINEDEBUG=-all $command measure crambin.pdb 2>/dev/null | grep -F 4247.656211 || { echo "$command does not run" && exit 1; }
done

# A package is of its processor, and everywhere of the same functions.
for package in "$release"/*_arm64.deb; do
  dpkg-deb -x "$package" arm64
  diff <(dpkg-deb -f "$package" Package Version Depends Provides | sed 's/ (>= [^)]*)//g') \
    <(dpkg-deb -f "${package/arm64/amd64}" Package Version Depends Provides | sed 's/ (>= [^)]*)//g')
done
readelf -h arm64/usr/bin/hardsphere arm64/usr/lib/aarch64-linux-gnu/libhardsphere.so.2 | grep -c AArch64 | grep -qx 2
[ -s arm64/usr/share/man/man1/hardsphere.1.gz ] || { echo "no manual page for arm64" && exit 1; }

# A user's machine.
cp -r "$release" "$work/user/release"
tar -C "$work/user/release" -xf "$release"/hardsphere_*.orig.tar.gz --strip-components 1
in_user() { chroot "$work/user" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C DEBIAN_FRONTEND=noninteractive AUTOPKGTEST_TMP=/tmp "$@"; }
run in_user sh -c 'cd /release && apt-get install -y -qq --no-install-recommends ./libhardsphere[0-9]*_amd64.deb ./hardsphere_*_amd64.deb'
in_user hardsphere measure /release/bench/molecules/crambin.pdb | grep -F 4247.656211
run in_user sh -c 'cd /release && apt-get install -y -qq --no-install-recommends ./libhardsphere-dev_*_amd64.deb ./python3-hardsphere_*.deb \
  gcc libc6-dev gfortran pkgconf'
for test in c-program fortran-program python-module; do in_user sh -c "cd /release && sh capi/package/debian/tests/$test"; done
# Installed files can be taken away again.
run in_user apt-get purge -y -qq hardsphere libhardsphere-dev python3-hardsphere "libhardsphere*"
[ -z "$(find "$work/user/usr" -name '*hardsphere*')" ] || { find "$work/user/usr" -name '*hardsphere*' && exit 1; }
cat "$release/SHA256SUMS"
rm -rf "$work/user"
