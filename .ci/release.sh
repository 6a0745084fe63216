#!/usr/bin/env bash
# Makes what a release consists of, from the commit that is checked out:
#   bash .ci/release.sh OUTPUT-FOLDER [CHROOT]
#     hardsphere-VERSION.tar.gz                        the source archive: the same bytes from the same commit
#     hardsphere-VERSION-core.tar.gz                   the core as one file: hardsphere.cpp and hardsphere.h
#     hardsphere_VERSION-1.dsc and what belongs to it  the source package for Debian; its debian/ is written here
#     *.deb                                            library, development files, program
#     SHA256SUMS                                       checksums of all of them
# The packages are built on this machine or, as root, in the folder CHROOT, a bare Debian as debootstrap makes it; what
# they need is installed there. lintian has to find nothing: neither errors nor warnings. Needs git, python3, dpkg-dev,
# debhelper, lintian. DEBFULLNAME and DEBEMAIL name the maintainer; DEB_BUILD_OPTIONS is Debian's.
#   bash .ci/release.sh --sign FOLDER                  checksums of a folder's files, and their signature
#   bash .ci/release.sh --verify KEY FOLDER            whether both are right; KEY is the file of the public key
# HSP_RELEASE_KEY names the file of a secret key of minisign: SHA256SUMS.minisig is the signature.
set -euo pipefail
case "${1:-}" in
  --sign)
    cd "$2"
    rm -f SHA256SUMS SHA256SUMS.minisig
    sha256sum -- * >SHA256SUMS
    if [ -n "${HSP_RELEASE_KEY:-}" ]; then minisign -S -s "$HSP_RELEASE_KEY" -m SHA256SUMS </dev/null >/dev/null; fi
    exit 0
    ;;
  --verify)
    minisign -V -q -p "$2" -m "$3/SHA256SUMS"
    cd "$3"
    sha256sum --check --quiet --strict SHA256SUMS
    # Nothing lies beside what was signed.
    diff <(sed 's/^[0-9a-f]* [ *]//' SHA256SUMS | sort) <(find . -type f ! -name 'SHA256SUMS*' -printf '%P\n' | sort)
    exit 0
    ;;
esac
cd "$(dirname "$0")/.."
[ $# -eq 1 ] || [ $# -eq 2 ] || { sed -n '2,/^[^#]/s/^# \{0,1\}//p' .ci/release.sh && exit 2; }
mkdir -p "$1"
output=$(cd "$1" && pwd) chroot=${2:-}

version=$(sed -nE 's/^#define HSP_VERSION_STRING "([0-9.]+)".*/\1/p' include/hardsphere/version.h)
abi=$(sed -nE 's/^#define HSP_ABI_NUMBER ([0-9]+).*/\1/p' include/hardsphere/version.h)
date=$(git log -1 --format=%cD)
maintainer="${DEBFULLNAME:-The hardsphere authors} <${DEBEMAIL:-hardsphere@packages.debian.org}>"

# The source archive.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
git archive --format=tar --prefix="hardsphere-$version/" HEAD | gzip -n -9 >"$output/hardsphere-$version.tar.gz"
python3 .ci/one_file.py "$work/hardsphere-$version-core"
tar -C "$work" --sort=name --mtime="$date" --owner=0 --group=0 --numeric-owner --mode=u=rwX,go=rX -c "hardsphere-$version-core" |
  gzip -n -9 >"$output/hardsphere-$version-core.tar.gz"
cp "$output/hardsphere-$version.tar.gz" "$work/hardsphere_$version.orig.tar.gz"
tar -C "$work" -xf "$work/hardsphere_$version.orig.tar.gz"
tree=$work/hardsphere-$version

# The folder debian/.
mkdir -p "$tree/debian/source"
echo '3.0 (quilt)' >"$tree/debian/source/format"
cat >"$tree/debian/control" <<CONTROL
Source: hardsphere
Section: science
Priority: optional
Maintainer: $maintainer
Build-Depends: debhelper-compat (= 13), cmake, ninja-build
Standards-Version: 4.6.2
Rules-Requires-Root: no

Package: libhardsphere$abi
Section: libs
Architecture: any
Multi-Arch: same
Pre-Depends: \${misc:Pre-Depends}
Depends: \${shlibs:Depends}, \${misc:Depends}
Description: exact geometry of molecules given as balls
 Areas and volumes of unions of balls with their gradients, the boundary with
 its faces, shells and voids, solvent-excluded surfaces, contacts, paths, and
 vector pictures with hidden parts removed. The library allocates no memory
 and decides every question in integers: it gives the same bits on every
 machine.

Package: libhardsphere-dev
Section: libdevel
Architecture: any
Multi-Arch: same
Depends: libhardsphere$abi (= \${binary:Version}), \${misc:Depends}
Description: exact geometry of molecules given as balls, development files
 Areas and volumes of unions of balls with their gradients, the boundary with
 its faces, shells and voids, solvent-excluded surfaces, contacts, paths, and
 vector pictures with hidden parts removed.
 .
 Headers, the archive, a CMake package and a pkg-config file, the source of
 the Fortran modules, guides and examples.

Package: hardsphere
Architecture: any
Depends: \${shlibs:Depends}, \${misc:Depends}
Description: exact geometry of molecules given as balls, command-line program
 Areas and volumes of molecules, in total and by atom, residue or contact,
 with their voids, paths and pictures: from PDB, mmCIF, GRO, PQR and XYZ files
 and from trajectories.
CONTROL
cat >"$tree/debian/rules" <<'RULES'
#!/usr/bin/make -f
export DEB_BUILD_MAINT_OPTIONS := hardening=+all
# The archive first, so that the CMake package that stays is that of the shared library.
KINDS := OFF ON
OPTIONS := -DHSP_TESTS=OFF -DHSP_BENCH=OFF -DHSP_FUZZ=OFF -DHSP_FORTRAN=OFF -DHSP_TOOL_STATIC=OFF \
  -DCMAKE_INSTALL_DOCDIR=share/doc/libhardsphere-dev
%:
	dh $@ --buildsystem=cmake+ninja
override_dh_auto_configure:
	$(foreach kind,$(KINDS),dh_auto_configure -Bbuild-shared-$(kind) -- $(OPTIONS) -DBUILD_SHARED_LIBS=$(kind) &&) true
override_dh_auto_build:
	$(foreach kind,$(KINDS),dh_auto_build -Bbuild-shared-$(kind) &&) true
override_dh_auto_install:
	$(foreach kind,$(KINDS),dh_auto_install -Bbuild-shared-$(kind) --destdir=debian/tmp &&) true
override_dh_auto_clean:
	$(foreach kind,$(KINDS),dh_auto_clean -Bbuild-shared-$(kind) &&) true
ifeq (,$(filter nocheck,$(DEB_BUILD_OPTIONS)))
override_dh_auto_test:
	build-shared-ON/capi/hardsphere measure bench/molecules/caffeine.pdb
else
override_dh_auto_test:
endif
RULES
chmod +x "$tree/debian/rules"
echo 'usr/lib/*/libhardsphere.so.*' >"$tree/debian/libhardsphere$abi.install"
printf '%s\n' usr/include 'usr/lib/*/libhardsphere.a' 'usr/lib/*/libhardsphere.so' 'usr/lib/*/cmake' 'usr/lib/*/pkgconfig' \
  usr/share/doc/libhardsphere-dev/README.md usr/share/doc/libhardsphere-dev/CHANGELOG.md usr/share/doc/libhardsphere-dev/guide usr/share/doc/libhardsphere-dev/examples \
  usr/share/doc/libhardsphere-dev/clients \
  >"$tree/debian/libhardsphere-dev.install"
printf '%s\n' usr/bin usr/share/man usr/share/bash-completion usr/share/zsh >"$tree/debian/hardsphere.install"
# The Python module comes as a wheel (capi/python).
printf '%s\n' usr/share/doc/libhardsphere-dev/LICENSE 'usr/lib/*/python3' >"$tree/debian/not-installed"
{
  echo 'Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/'
  printf 'Upstream-Name: hardsphere\n\nFiles: *\nCopyright: '
  sed -nE 's/^Copyright \(c\) //p' LICENSE
  printf 'License: Expat\n'
  sed -n '/^Permission/,$p' LICENSE | sed -e 's/^$/./' -e 's/^/ /'
} >"$tree/debian/copyright"
# An entry for every version that the list of changes has. Nobody has asked Debian for the package: no number to close.
{
  sed -nE 's/^## ([0-9]+\.[0-9]+\.[0-9]+), /\1 /p' .github/CHANGELOG.md | while read -r release day; do
    [[ $day =~ ^[0-9]{4}(-[0-9]{2}){2}$ ]] && day=$(date -u -R -d "$day") || day=$date
    printf 'hardsphere (%s-1) unstable; urgency=medium\n\n  * See /usr/share/doc/libhardsphere-dev.\n\n -- %s  %s\n\n' \
      "$release" "$maintainer" "$day"
  done | sed '$d'
} >"$tree/debian/changelog"
[ "$(sed -nE '1s/.*\(([0-9.]+)-1\).*/\1/p' "$tree/debian/changelog")" = "$version" ] ||
  { echo "the first version of .github/CHANGELOG.md is not $version" >&2 && exit 1; }

# The packages.
(cd "$work" && dpkg-source -b "hardsphere-$version")
if [ -n "$chroot" ]; then
  rm -rf "$chroot/release"
  mkdir "$chroot/release"
  cp "$work"/hardsphere_* "$chroot/release"
  run_there() { chroot "$chroot" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C DEBIAN_FRONTEND=noninteractive \
    DEB_BUILD_OPTIONS="${DEB_BUILD_OPTIONS:-}" "$@"; }
  run_there apt-get install -y -qq --no-install-recommends build-essential debhelper cmake ninja-build
  run_there sh -c "cd /release && dpkg-source -x hardsphere_$version-1.dsc && cd hardsphere-$version &&
    dpkg-buildpackage -us -uc -b"
  rm -rf "$chroot/release/hardsphere-$version"
  cp "$chroot"/release/* "$work"
else
  (cd "$tree" && dpkg-buildpackage -us -uc -b)
fi
lintian --fail-on error,warning "$work"/*.changes "$work"/*.dsc
rm -rf "$tree" "$work"/*dbgsym*
cp "$work"/hardsphere_*.{dsc,orig.tar.gz,debian.tar.xz} "$work"/*.deb "$output"
bash .ci/release.sh --sign "$output"
cat "$output/SHA256SUMS"
