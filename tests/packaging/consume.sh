#!/usr/bin/env bash
# Builds and runs a user's program in one language against the package, and looks at what it links.
#   consume.sh WAY LANGUAGE SOURCE-FOLDER INSTALL-PREFIX WORK-FOLDER COMPILER
# WAY: find_package, subdirectory or pkg_config. LANGUAGE: C, CXX or Fortran.
set -euo pipefail
way=$1 language=$2 source=$3 prefix=$4 work=$5 compiler=$6
here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$work"
mkdir -p "$work"
program=$work/consumer_$language

case $way in
  find_package | subdirectory)
    where=-DCMAKE_PREFIX_PATH=$prefix
    [ "$way" = subdirectory ] && where=-DHARDSPHERE_SOURCE=$source
    cmake -S "$here/consumers/$way" -B "$work" -DLANGUAGE="$language" -DCMAKE_BUILD_TYPE=Release \
      -DCMAKE_"${language}"_COMPILER="$compiler" "$where" \
      >"$work/log" 2>&1 || { cat "$work/log" && exit 1; }
    cmake --build "$work" --parallel 2 >>"$work/log" 2>&1 || { cat "$work/log" && exit 1; }
    ;;
  pkg_config)
    # The prefix is found from where the .pc file lies: the tree may be moved.
    mv "$prefix" "$prefix.moved"
    trap 'mv "$prefix.moved" "$prefix"' EXIT
    export PKG_CONFIG_PATH
    PKG_CONFIG_PATH=$(dirname "$(find "$prefix.moved" -name hardsphere.pc)")
    pkg-config --validate hardsphere
    read -ra flags <<<"$(pkg-config --cflags hardsphere)"
    read -ra libs <<<"$(pkg-config --libs hardsphere)"
    case $language in
      C) "$compiler" -std=c99 "${flags[@]}" -o "$program" "$here/consumers/main.c" "${libs[@]}" ;;
      CXX) "$compiler" -std=c++20 "${flags[@]}" -o "$program" "$here/consumers/main.cpp" "${libs[@]}" ;;
      Fortran)
        # any Fortran compiler: it compiles the module's source, which is installed
        module=$(find "$prefix.moved" -name hardsphere.f90)
        (cd "$work" && "$compiler" -o "$program" "$module" "$here/consumers/main.f90" "${libs[@]}")
        ;;
    esac
    ;;
  *)
    echo "unknown way: $way"
    exit 1
    ;;
esac

"$program"
linked=$(readelf -d "$program" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p')
echo "links:" $linked
if [ "$language" != CXX ] && grep -qE 'stdc\+\+|libc\+\+' <<<"$linked"; then
  echo "a program in $language links the C++ run-time library"
  exit 1
fi
