#!/usr/bin/env bash
# Makes what a release consists of, from the commit that is checked out:
#   bash .ci/release.sh OUTPUT-FOLDER [CHROOT]
#     hardsphere-VERSION.tar.gz                        the source archive
#     hardsphere-VERSION-core.tar.gz                   the core as one file: hardsphere.cpp and hardsphere.h
#     hardsphere_VERSION-1.dsc and what belongs to it  the source package for Debian (capi/package/debian)
#     *.deb                                            library, development files, program, Python module: amd64, arm64
#     hardsphere-VERSION-linux-x86_64.tar.gz, -windows-x86_64.zip, -wasm32.tar.gz   programs that need no library
#     hardsphere-VERSION.html                          the page in the browser
#     SHA256SUMS                                       checksums of all of them
# The same commit gives the same bytes, wherever and whenever it is built with the same compilers. The packages are built on
# this machine or, as root, in the folder CHROOT, a bare Debian as debootstrap makes it; what they need is installed there.
# lintian has to find nothing: neither errors nor warnings. Needs packages of .ci/install.sh, of those for long tests.
# HSP_RELEASE_PARTS: some of "debian arm64 linux windows wasm"; without it all. DEBFULLNAME and DEBEMAIL name the maintainer;
# DEB_BUILD_OPTIONS is Debian's, whose noopt holds for the programs too.
#   bash .ci/release.sh --sign FOLDER                  checksums of a folder's files, and their signature
#   bash .ci/release.sh --verify KEY FOLDER            whether both are right; KEY is the file of the public key
# HSP_RELEASE_KEY names the file of a secret key of minisign: SHA256SUMS.minisig is the signature.
set -euo pipefail
case "${1:-}" in
  --sign)
    cd "$2"
    rm -f SHA256SUMS SHA256SUMS.minisig
    (LC_ALL=C && sha256sum -- * >SHA256SUMS)
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

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# A launcher of compilers, as a cache, may write other paths into the debug information, of which the build's number is made.
unset CMAKE_C_COMPILER_LAUNCHER CMAKE_CXX_COMPILER_LAUNCHER
pack() { # folder
  tar -C "$work" --sort=name --mtime="$date" --owner=0 --group=0 --numeric-owner --mode=u=rwX,go=rX -c "$1" | gzip -n -9 >"$output/$1.tar.gz"
}

# The source archive.
git -c tar.umask=0022 archive --format=tar --prefix="hardsphere-$version/" HEAD | gzip -n -9 >"$output/hardsphere-$version.tar.gz"
python3 .ci/one_file.py "$work/hardsphere-$version-core"
pack "hardsphere-$version-core"
cp "$output/hardsphere-$version.tar.gz" "$work/hardsphere_$version.orig.tar.gz"
tar -C "$work" -xf "$work/hardsphere_$version.orig.tar.gz"
tree=$work/hardsphere-$version

# The folder debian/, with an entry for every version that the list of changes has. Nobody has asked Debian for the package:
# no number to close.
cp -r capi/package/debian "$tree/debian"
sed -i "s/^Maintainer: .*/Maintainer: $maintainer/" "$tree/debian/control"
grep -q "^Package: libhardsphere$abi$" "$tree/debian/control" || { echo "capi/package/debian has another ABI number" >&2 && exit 1; }
{
  echo 'Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/'
  printf 'Upstream-Name: hardsphere\n\nFiles: *\nCopyright: '
  sed -nE 's/^Copyright \(c\) //p' LICENSE
  printf 'License: Expat\n'
  sed -n '/^Permission/,$p' LICENSE | sed -e 's/^$/./' -e 's/^/ /'
} >"$tree/debian/copyright"
{
  sed -nE 's/^## ([0-9]+\.[0-9]+\.[0-9]+), /\1 /p' .github/CHANGELOG.md | while read -r release day; do
    [[ $day =~ ^[0-9]{4}(-[0-9]{2}){2}$ ]] && day=$(LC_ALL=C date -u -R -d "$day") || day=$date
    printf 'hardsphere (%s-1) unstable; urgency=medium\n\n  * See /usr/share/doc/libhardsphere-dev.\n\n -- %s  %s\n\n' \
      "$release" "$maintainer" "$day"
  done | sed '$d'
} >"$tree/debian/changelog"
[ "$(sed -nE '1s/.*\(([0-9.]+)-1\).*/\1/p' "$tree/debian/changelog")" = "$version" ] ||
  { echo "the first version of .github/CHANGELOG.md is not $version" >&2 && exit 1; }
chmod -R u=rwX,go=rX "$tree" # whatever umask says: dpkg-source keeps it
(cd "$work" && dpkg-source -b "hardsphere-$version")
cp "$work"/hardsphere_*.{dsc,orig.tar.gz,debian.tar.xz} "$output"

# Programs that need no shared library. The one for this machine writes manual pages for others, too.
optimization=-O3
[[ " ${DEB_BUILD_OPTIONS:-} " != *" noopt "* ]] || optimization=-O0
program() { # system, option of CMake...
  local system=$1 folder=hardsphere-$version-$1
  shift
  LDFLAGS=-s cmake -S "$tree" -B "$work/$system" -G Ninja -DCMAKE_BUILD_TYPE=Release -DHSP_TOOL=ON -DHSP_TESTS=OFF -DHSP_BENCH=OFF \
    -DHSP_FUZZ=OFF -DHSP_FORTRAN=OFF "-DCMAKE_C_FLAGS_RELEASE=${optimization/3/2} -DNDEBUG -fno-asynchronous-unwind-tables" \
    "-DCMAKE_CXX_FLAGS_RELEASE=$optimization -DNDEBUG" "$@"
  cmake --build "$work/$system" --target hardsphere_tool --parallel "${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}"
  cmake --install "$work/$system" --component hardsphere_runtime --prefix "$work/$folder"
  cp LICENSE "$work/$folder"
  if [ "$system" = wasm32 ]; then
    cp capi/wasm/run.mjs "$work/$folder"
    bash capi/examples/web/make_page.sh "$work/$folder/bin/hardsphere.wasm" >"$output/hardsphere-$version.html"
  fi
  find "$work/$folder" -exec chmod u=rwX,go=rX {} + -exec touch -d "$date" {} +
  case $system in
    windows*) (cd "$work" && TZ=UTC python3 -m zipfile -c "$output/$folder.zip" "$folder") ;;
    *) pack "$folder" ;;
  esac
}
is_part() { [[ " ${HSP_RELEASE_PARTS-debian arm64 linux windows wasm} " == *" $1 "* ]]; }
if is_part linux || is_part arm64; then program linux-x86_64; fi
if is_part windows; then program windows-x86_64 -DCMAKE_TOOLCHAIN_FILE=tests/packaging/windows/mingw.cmake; fi
if is_part wasm; then program wasm32 -DCMAKE_TOOLCHAIN_FILE=capi/wasm/wasi.cmake; fi

# The packages: all of this machine, those of another processor for it alone.
packages() { # options of dpkg-buildpackage
  cp -r "$tree" "$work/build"
  if [ -n "$chroot" ]; then
    rm -rf "$chroot/release"
    mkdir "$chroot/release"
    mv "$work/build" "$chroot/release"
    if [ -e "$work/linux-x86_64" ]; then cp "$work/linux-x86_64/capi/hardsphere" "$chroot/release/native"; fi
    chroot "$chroot" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C HSP_NATIVE_TOOL=/release/native \
      DEB_BUILD_OPTIONS="${DEB_BUILD_OPTIONS:-}" sh -c "cd /release/build && dpkg-buildpackage -us -uc $*"
    cp "$chroot"/release/*.{deb,changes,buildinfo} "$work"
  else
    (cd "$work/build" && HSP_NATIVE_TOOL=$work/linux-x86_64/capi/hardsphere dpkg-buildpackage -us -uc "$@")
    rm -rf "$work/build"
  fi
}
there() { [ -z "$chroot" ] || chroot "$chroot" env DEBIAN_FRONTEND=noninteractive LC_ALL=C "$@"; }
if is_part debian || is_part arm64; then
  there apt-get install -y -qq --no-install-recommends build-essential debhelper cmake ninja-build dh-python python3
fi
if is_part debian; then packages -b; fi
if is_part arm64; then
  there apt-get install -y -qq --no-install-recommends g++-aarch64-linux-gnu
  packages -B -aarm64 -d # the program of this machine is no package yet
fi
if is_part debian || is_part arm64; then
  lintian --fail-on error,warning "$work"/*.changes "$work"/*.dsc
  rm -f "$work"/*dbgsym*
  cp "$work"/*.deb "$output"
fi
bash .ci/release.sh --sign "$output"
cat "$output/SHA256SUMS"
