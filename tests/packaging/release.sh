#!/usr/bin/env bash
# A release (.ci/release.sh): source archive, packages for Debian, checksums. The packages are built in a bare Debian and
# installed in another one, where the program runs and programs are compiled with the library.
#   release.sh SOURCE-FOLDER WORK-FOLDER
# Exit status 77: it needs root, debootstrap, the tools for packages, and the archive of Debian that apt uses.
set -euo pipefail
source=$1 work=$2
skip() {
  echo "skipped: $*"
  exit 77
}
[ "$(id -u)" -eq 0 ] || skip "only root can make a bare Debian"
for needed in git debootstrap dpkg-buildpackage dh lintian; do
  command -v $needed >/dev/null || skip "there is no $needed here; packages git debootstrap dpkg-dev debhelper lintian"
done
git -C "$source" rev-parse -q --verify HEAD >/dev/null 2>&1 || skip "the sources are in no repository"
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

# Without optimisation, which is sooner compiled.
export DEB_BUILD_OPTIONS=noopt
run bash "$source/.ci/release.sh" "$work/release" "$work/builder"
(cd "$work/release" && sha256sum --check --quiet SHA256SUMS)
rm -rf "$work/builder"

cp -r "$work/release" "$work/user/release"
cp "$source/bench/molecules/crambin.pdb" "$source/capi/examples/minimal.c" "$work/user/release"
in_user() { chroot "$work/user" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C DEBIAN_FRONTEND=noninteractive "$@"; }
run in_user sh -c 'cd /release && apt-get install -y -qq --no-install-recommends ./libhardsphere[0-9]*.deb ./hardsphere_*.deb'
in_user hardsphere measure /release/crambin.pdb | grep -F 4247.656211
run in_user sh -c 'cd /release && apt-get install -y -qq --no-install-recommends ./libhardsphere-dev_*.deb gcc libc6-dev pkg-config'
# shellcheck disable=SC2016 # in there
run in_user sh -c 'cd /release && gcc -std=c99 minimal.c $(pkg-config --cflags --libs hardsphere) -o shared &&
  gcc -std=c99 -static minimal.c $(pkg-config --cflags --libs hardsphere) -o static'
in_user /release/shared | grep -F 117.41
in_user /release/static | grep -F 117.41
# Installed files can be taken away again.
run in_user apt-get purge -y -qq hardsphere libhardsphere-dev "libhardsphere*"
[ -z "$(find "$work/user/usr" -name '*hardsphere*')" ] || { find "$work/user/usr" -name '*hardsphere*' && exit 1; }
cat "$work/release/SHA256SUMS"
rm -rf "$work/user"
