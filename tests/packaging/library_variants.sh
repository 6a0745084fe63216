#!/usr/bin/env bash
# The library as distributions and users with other tools make it, installed and linked by programs in C and C++.
#   library_variants.sh VARIANT SOURCE-FOLDER WORK-FOLDER C-COMPILER C++-COMPILER INSTALL-PREFIX
# VARIANT
#   shared     BUILD_SHARED_LIBS with the hardening flags of Debian: exports the header's functions and nothing else, has
#              a soname, needs no C++ run time
#   lto_fat    -g -flto=auto -ffat-lto-objects, as Fedora and Ubuntu build their packages; linked with and without -flto
#   lto        -flto alone
#   single     as one object: nothing but the header's functions in its symbol table; a project's own -ffinite-math-only and
#              -fsingle-precision-constant do not reach it
#   clang      compiled by clang, in a project that computes with -ffast-math; the program, too
#   lld        what is installed in INSTALL-PREFIX, linked by clang and lld
#   musl       the same, linked with the C library musl, statically
# The shared library and the single object with -O0, which inlines nothing that could be exported; others with -O1, which
# is compiled in half the time; but -flto, whose problem is the optimizer, with -O3. Exit status 77: a tool is missing here.
set -euo pipefail
export LC_ALL=C
variant=$1 source=$2 work=$3 cc=$4 cxx=$5 prefix=$6
here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$work"
mkdir -p "$work"

need() {
  command -v "$1" >/dev/null || { echo "skipped: there is no $1 here" && exit 77; }
}
flags='' optimization=-O1 options=() links=('')
hardening='-g -D_FORTIFY_SOURCE=2 -fstack-protector-strong -fstack-clash-protection -fcf-protection'
case $variant in
  shared) flags=$hardening optimization=-O0 options=(-DBUILD_SHARED_LIBS=ON) ;;
  lto_fat) flags='-g -flto=auto -ffat-lto-objects' optimization=-O3 links=('' '-flto=auto') ;;
  lto) flags='-flto' optimization=-O3 links=('-flto') ;;
  single)
    flags="-ffinite-math-only -fsingle-precision-constant" optimization=-O0 options=(-DHSP_SINGLE_OBJECT=ON)
    links=('-Wl,-z,relro -Wl,-z,now -pie -fPIE')
    ;;
  clang)
    cc=clang cxx=clang++ flags=-ffast-math options=(-DHSP_TOOL=ON)
    need clang && need clang++
    ;;
  lld)
    cc=clang cxx=clang++
    need clang && need ld.lld
    links=('-fuse-ld=lld' '-fuse-ld=lld -Wl,--gc-sections')
    ;;
  musl) need musl-gcc && links=('-static') ;;
  *) echo "unknown variant: $variant" && exit 1 ;;
esac

if [ "$variant" != musl ] && [ "$variant" != lld ]; then
  prefix=$work/prefix
  cmake -S "$source" -B "$work/build" -DCMAKE_C_COMPILER="$cc" -DCMAKE_CXX_COMPILER="$cxx" -DCMAKE_CXX_FLAGS="$flags" \
    -DCMAKE_C_FLAGS="$flags" -DCMAKE_CXX_FLAGS_RELEASE="$optimization -DNDEBUG" -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_INSTALL_PREFIX="$prefix" -DCMAKE_INSTALL_LIBDIR=lib \
    -DHSP_WERROR=ON -DHSP_TOOL=OFF -DHSP_TESTS=OFF -DHSP_BENCH=OFF -DHSP_FUZZ=OFF \
    -DHSP_FORTRAN=OFF "${options[@]}" &&
    cmake --build "$work/build" --parallel 2 && cmake --install "$work/build"
fi >"$work/log" 2>&1 || { tail -n 40 "$work/log" && exit 1; }
libraries=$(dirname "$(find "$prefix" -name 'libhardsphere.*' -print -quit)")

functions=$(bash "$here/header_functions.sh" "$source")
case $variant in
  shared)
    library=$libraries/libhardsphere.so
    diff -u --label header --label library <(echo "$functions") \
      <(readelf --dyn-syms -W "$library" | awk '$5 ~ /GLOBAL|WEAK/ && $7 != "UND" {print $8}' | sort)
    readelf -d "$library" >"$work/dynamic"
    abi=$(sed -nE 's/^#define HSP_ABI_NUMBER ([0-9]+)$/\1/p' "$source/include/hardsphere/version.h")
    grep -qF "[libhardsphere.so.$abi]" "$work/dynamic" || { echo "the soname does not end with ABI number $abi" && exit 1; }
    if grep -E 'NEEDED.*(stdc\+\+|libc\+\+)' "$work/dynamic"; then exit 1; fi
    # The Python module's own tests have a library made of the archive.
    if command -v python3 >/dev/null; then
      shot='import hardsphere; print(f"{hardsphere.measure([[0, 0, 0], [1, 0, 0]], [1, 1]).area:.6f}")'
      export PYTHONDONTWRITEBYTECODE=1
      [ "$(HARDSPHERE_LIBRARY=$library PYTHONPATH=$source/capi/python python3 -c "$shot")" = 18.849556 ]
      [ "$(PYTHONPATH=$prefix/lib/python3/dist-packages python3 -c "$shot")" = 18.849556 ]
    fi
    ;;
  lto*)
    # Every other entry in the symbol table of the archive is the library's own C++ code, in a namespace.
    nm -g --defined-only "$libraries/libhardsphere.a" 2>/dev/null | awk 'NF == 3 {print $3}' | sort -u >"$work/symbols"
    diff -u --label header --label archive <(echo "$functions") <(grep '^hsp_' "$work/symbols")
    if grep -vE '^hsp_|^_Z' "$work/symbols"; then echo "other symbols than the library's own" && exit 1; fi
    # c++filt does not know all names of lambdas in lambdas.
    if c++filt <"$work/symbols" | grep -vE '^hsp_|hsp::|^_ZNK?3hsp'; then echo "C++ code of others" && exit 1; fi
    ;;
  single | clang | lld | musl) bash "$here/archive_symbols.sh" "$libraries/libhardsphere.a" "$source" ;;
esac
# Arithmetic without NaN would print a number that is not known.
if [ "$variant" = clang ]; then
  echo 0 0 0 1 >"$work/one.xyzr"
  "$prefix/bin/hardsphere" model --json "$work/one.xyzr" | grep -q '"rho": null'
fi

# Programs in C99, C++20 and C++23.
PKG_CONFIG_PATH=$libraries/pkgconfig
export PKG_CONFIG_PATH
read -ra package <<<"$(pkg-config --cflags --libs hardsphere)"
build_and_run() { # compiler and flags
  "$@" "${package[@]}" -o "$work/program"
  LD_LIBRARY_PATH=$libraries "$work/program" >"$work/output"
  [ -s "$work/output" ] || { echo "it prints nothing" && exit 1; }
}
for link in "${links[@]}"; do
  read -ra words <<<"$link"
  if [ "$variant" = musl ]; then
    build_and_run musl-gcc -std=c99 "${words[@]}" "$here/consumers/main.c"
    continue
  fi
  build_and_run "$cc" -std=c99 "${words[@]}" "$here/consumers/main.c"
  build_and_run "$cxx" -std=c++20 "${words[@]}" "$here/consumers/main.cpp"
  build_and_run "$cxx" -std=c++2b "${words[@]}" "$here/consumers/main.cpp"
done
echo "$variant: $(cat "$work/output")"
rm -rf "$work/build"
