#!/usr/bin/env bash
# Builds and runs a user's program in one language against the package, and looks at what it links.
#   consume.sh WAY LANGUAGE SOURCE-FOLDER INSTALL-PREFIX WORK-FOLDER COMPILER
# WAY: find_package, subdirectory or pkg_config; for Fortran also find_package_source and pkg_config_source, which meet
# the package as a Fortran compiler does that the module was not compiled with. LANGUAGE: C, CXX or Fortran.
set -euo pipefail
way=$1 language=$2 source=$3 prefix=$4 work=$5 compiler=$6
here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$work"
mkdir -p "$work"
program=$work/consumer_$language

# The package without anything that a Fortran compiler has written.
if [ "$way" = find_package_source ] || [ "$way" = pkg_config_source ]; then
  cp -R "$prefix" "$work/package"
  prefix=$work/package
  compiled=$(find "$prefix" -name hardsphere.mod -o -name libhardsphere_fortran.a -o -name hardsphere_fortran.pc \
    -o -name 'hardsphere-fortran-*.cmake')
  [ "$(wc -l <<<"$compiled")" -ge 4 ] || { echo "the package holds no compiled module: $compiled" && exit 1; }
  xargs rm <<<"$compiled"
fi

case $way in
  find_package | find_package_source | subdirectory)
    where=-DCMAKE_PREFIX_PATH=$prefix
    # The library is compiled here: in large units, and without optimisation.
    [ "$way" = subdirectory ] &&
      where="-DHARDSPHERE_SOURCE=$source -DCMAKE_CXX_FLAGS_RELEASE=-O0"
    # shellcheck disable=SC2086 # several options
    cmake -S "$here/consumers/${way%_source}" -B "$work" -DLANGUAGE="$language" -DCMAKE_BUILD_TYPE=Release \
      -DCMAKE_"${language}"_COMPILER="$compiler" $where \
      >"$work/log" 2>&1 || { cat "$work/log" && exit 1; }
    cmake --build "$work" --parallel 2 >>"$work/log" 2>&1 || { cat "$work/log" && exit 1; }
    # The compiler that compiled the package's module reads that; every other compiles its own.
    if [ "$language" = Fortran ] && [ "$way" != subdirectory ]; then
      own=$(find "$work" -name hardsphere.mod | wc -l)
      [ "$own" -eq "$([ "$way" = find_package ] && echo 0 || echo 1)" ] || { echo "$own own modules" && exit 1; }
    fi
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
        pkg-config --validate hardsphere_fortran
        read -ra flags <<<"$(pkg-config --cflags hardsphere_fortran)"
        read -ra libs <<<"$(pkg-config --libs hardsphere_fortran)"
        (cd "$work" && "$compiler" "${flags[@]}" -o "$program" "$here/consumers/main.f90" "${libs[@]}")
        ;;
    esac
    ;;
  pkg_config_source)
    export PKG_CONFIG_PATH
    PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name hardsphere.pc)")
    module=$(pkg-config --variable=module_source hardsphere)
    read -ra libs <<<"$(pkg-config --libs hardsphere)"
    (cd "$work" && "$compiler" -std=f2018 -o "$program" "$module" "$here/consumers/main.f90" "${libs[@]}")
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
