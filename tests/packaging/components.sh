#!/usr/bin/env bash
# The library with a part of its components, installed: it needs nothing that was left out, and its headers, its Fortran
# modules and its package say what is there. Programs in C and Fortran link with it, whose sizes are printed.
#   components.sh SOURCE-FOLDER WORK-FOLDER C-COMPILER C++-COMPILER [FORTRAN-COMPILER]
set -euo pipefail
export LC_ALL=C
source=$1 work=$2 cc=$3 cxx=$4 fortran=${5:-}
here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$work"
mkdir -p "$work"
fail() {
  echo "$components: $*"
  exit 1
}
# The tests of the interface that the build has.
list_tests() {
  mapfile -t tests < <(cmake --build "$build" --target help | grep -oE 'api_[a-z]+_tests' | sort -u)
  [ ${#tests[@]} -ge 7 ]
}
package() { # options: installs into $prefix what is chosen
  build=$work/build_$name prefix=$work/prefix_$name
  {
    cmake -S "$source" -B "$build" -DCMAKE_C_COMPILER="$cc" -DCMAKE_CXX_COMPILER="$cxx" -DCMAKE_BUILD_TYPE=Release \
      -DCMAKE_INSTALL_LIBDIR=lib -DHSP_COMPONENTS="$chosen" -DHSP_WERROR=ON -DHSP_TOOL=ON -DHSP_TESTS=ON \
      -DHSP_BENCH=OFF -DHSP_FUZZ=OFF "$@" && list_tests &&
      cmake --build "$build" --parallel 2 --target hardsphere ${program:+hardsphere_tool} "${tests[@]}" &&
      if [ -n "$fortran" ] && [ "$name" = none ]; then cmake --build "$build" --target hardsphere_fortran; fi &&
      cmake --install "$build" --prefix "$prefix"
  } >"$work/log" 2>&1 || { tail -n 40 "$work/log" && exit 1; }
  (cd "$build" && ctest -R '^api_' -E 'threads|cxx20|fortran' --no-tests=error) >"$work/log" 2>&1 ||
    { tail -n 40 "$work/log" && fail "tests of the interface"; }
  ran=$(grep -oE 'out of [0-9]+' "$work/log")
}
text() { # of a program that runs
  "$1" >/dev/null || fail "$1 fails"
  size "$1" | awk 'NR == 2 {print $1}'
}

# Components that are chosen, and those that the library has then: with each all that it stands on.
while IFS=: read -r chosen components; do
  name=${chosen%%;*}
  name=${name:-none}
  # The program needs four of them.
  program=
  [[ "$components " != *residues*curvature*motion*boxes* ]] || program=yes
  options=(-DCMAKE_CXX_FLAGS_RELEASE=-O0 -DHSP_FORTRAN=OFF)
  # The smallest as everybody compiles it.
  if [ "$name" = none ]; then
    options=(-DHSP_FORTRAN=OFF)
    if [ -n "$fortran" ]; then options=(-DHSP_FORTRAN=ON -DCMAKE_Fortran_COMPILER="$fortran"); fi
  fi
  package "${options[@]}"
  # With all objects linked, nothing of the library is missing; what is declared is there, and nothing else.
  "$cc" -r -nostdlib -o "$work/whole.o" -Wl,--whole-archive "$prefix/lib/libhardsphere.a" -Wl,--no-whole-archive
  missing=$(nm -u "$work/whole.o" | grep -E 'hsp' || true)
  [ -z "$missing" ] || fail "missing $missing"
  # (A function's declaration is no typedef.)
  echo '#include <hardsphere.h>' | "$cc" -std=c99 -E -P -I"$prefix/include" -x c - |
    grep -v '^typedef' | grep -oE 'hsp_[a-z0-9_]+\(' | tr -d '(' | sort -u >"$work/functions"
  bash "$here/archive_symbols.sh" "$prefix/lib/libhardsphere.a" "$source" "$work/functions" >"$work/symbols" ||
    { cat "$work/symbols" && fail "headers and archive differ"; }
  # Fortran's interfaces are those of the headers, and both workspaces compile.
  diff "$work/functions" \
    <(sed -nE 's/.*bind\(C, *name="(hsp_[a-z0-9_]+)"\).*/\1/p' "$prefix/include/hardsphere/hardsphere.f90" | sort) ||
    fail "the Fortran module declares something else than the headers"
  echo '#include <hardsphere_workspace.h>' | "$cc" -std=c99 -Wall -Wextra -Wno-unused-function -Werror -fsyntax-only \
    -I"$prefix/include" -x c - || fail "hardsphere_workspace.h does not compile"
  echo '#include <hardsphere.hpp>' | "$cxx" -std=c++20 -Wall -Wextra -Wno-unused-function -Werror -fsyntax-only \
    -I"$prefix/include" -x c++ - || fail "hardsphere.hpp does not compile"
  if [ -n "$fortran" ]; then
    "$fortran" -fsyntax-only -J "$work" "$prefix"/include/hardsphere/hardsphere{,_workspace}.f90 ||
      fail "the Fortran modules do not compile"
  fi
  export PKG_CONFIG_PATH=$prefix/lib/pkgconfig
  listed=$(pkg-config --variable=components hardsphere)
  [ "$listed" = "$components" ] || fail "pkg-config says $listed"
  # A package that is asked for a component that it lacks is not found.
  for asked in residues curvature motion bricks boxes smooth space sight; do
    mkdir -p "$work/$asked"
    printf '%s\n' "cmake_minimum_required(VERSION 3.21)" "project(user LANGUAGES C)" \
      "find_package(hardsphere REQUIRED COMPONENTS $asked)" >"$work/$asked/CMakeLists.txt"
    found=0
    cmake -S "$work/$asked" -B "$work/$asked/build_$name" -DCMAKE_C_COMPILER="$cc" -DCMAKE_PREFIX_PATH="$prefix" \
      >"$work/log" 2>&1 && found=1
    [ $found -eq "$([[ " $components " == *" $asked "* ]] && echo 1 || echo 0)" ] ||
      { tail -n 10 "$work/log" && fail "find_package with component $asked"; }
  done
  read -ra flags <<<"$(pkg-config --cflags --libs hardsphere)"
  "$cc" -std=c99 -O2 "$here/consumers/main.c" "${flags[@]}" -o "$work/area"
  echo "${components:-none}: $(stat -c %s "$prefix/lib/libhardsphere.a") bytes of archive," \
    "$(wc -l <"$work/functions") functions, ${ran#out of } tests of the interface," \
    "$(text "$work/area") bytes of text of a program in C that measures an area"
  # The program says what it lacks.
  if [ -n "$program" ]; then
    status=0
    "$prefix/bin/hardsphere" draw "$source/bench/molecules/caffeine.pdb" -o "$work/none.svg" 2>"$work/log" || status=$?
    [ $status -eq 2 ] && grep -q 'draw needs the part that draws' "$work/log" || { cat "$work/log" && fail "draw: status $status"; }
  fi
  if [ "$name" = none ] && [ -n "$fortran" ]; then
    read -ra flags <<<"$(pkg-config --cflags --libs hardsphere_fortran hardsphere)"
    "$fortran" -O2 "$here/consumers/main.f90" "${flags[@]}" -J "$work" -o "$work/area_fortran"
    echo "none: $(text "$work/area_fortran") bytes of text of one in Fortran"
  fi
done <<'CHOICES'
:
motion:motion
bricks:bricks
boxes:curvature boxes
smooth:smooth
space:curvature boxes space
sight:sight
residues;motion;boxes;smooth:residues curvature motion boxes smooth
CHOICES
rm -rf "$work"
