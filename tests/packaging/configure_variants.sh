#!/usr/bin/env bash
# The default build where nothing is asked for: on a machine with nothing but compilers, and in somebody else's project.
#   configure_variants.sh SOURCE-FOLDER WORK-FOLDER C-COMPILER C++-COMPILER
set -euo pipefail
source=$1 work=$2 cc=$3 cxx=$4
rm -rf "$work"
mkdir -p "$work"
failed=0
fail() {
  echo "$*"
  failed=1
}
value() { # of an option in a build folder's cache
  sed -n "s/^$2:[A-Z]*=//p" "$work/$1/CMakeCache.txt"
}
configure() { # name, source folder, options
  local name=$1 folder=$2
  shift 2
  cmake -S "$folder" -B "$work/$name" -DCMAKE_C_COMPILER="$cc" -DCMAKE_CXX_COMPILER="$cxx" \
    -DCMAKE_EXPORT_COMPILE_COMMANDS=ON "$@" >"$work/$name.log" 2>&1 || { tail -n 30 "$work/$name.log" && exit 1; }
}
has_flag() { # name, flag: whether the library is compiled with it
  grep -F "Unity/exact.cpp" "$work/$1/compile_commands.json" | grep -qE -- "(^| )$2( |\$)"
}

# No GoogleTest, no Google Benchmark, no Fortran compiler.
configure bare "$source" -DCMAKE_DISABLE_FIND_PACKAGE_GTest=ON -DCMAKE_DISABLE_FIND_PACKAGE_benchmark=ON \
  -DCMAKE_Fortran_COMPILER=NOTFOUND
for option in HSP_TESTS HSP_BENCH HSP_FUZZ HSP_FORTRAN; do
  case $(value bare $option) in OFF | FALSE | 0) ;; *) fail "$option is on where its package is missing" ;; esac
done
[ "$(value bare HSP_TOOL)" = ON ] || fail "the program is not built"
has_flag bare -O3 || fail "not optimized by default"
has_flag bare -fPIC || fail "not position-independent by default"
configure fixed "$source" -DCMAKE_POSITION_INDEPENDENT_CODE=OFF -DHSP_TESTS=OFF -DHSP_BENCH=OFF -DHSP_FORTRAN=OFF
if has_flag fixed -fPIC; then fail "position-independent although CMAKE_POSITION_INDEPENDENT_CODE is off"; fi

# Packages that are there in part do not matter to whom the library is enough, nor to the default.
mkdir "$work/broken"
for name in doxygen dot mpicc mpicxx mpiexec; do
  printf '#!/bin/sh\necho "$0: error while loading shared libraries" >&2\nexit 127\n' >"$work/broken/$name"
done
chmod +x "$work/broken"/*
PATH=$work/broken:$PATH configure half "$source"
PATH=$work/broken:$PATH configure half_alone "$source" -DHSP_TESTS=OFF -DHSP_BENCH=OFF -DHSP_FUZZ=OFF
# The search for documentation is made when it is asked for, and fails then.
if (PATH=$work/broken:$PATH configure half_asked "$source" -DHSP_TESTS=OFF -DHSP_DOCUMENTATION=ON) >/dev/null; then
  fail "this would not notice a search for Doxygen"
fi
# Files of the program have static functions of one name: none is compiled with others.
configure unity "$source" -DCMAKE_UNITY_BUILD=ON -DHSP_TESTS=OFF -DHSP_BENCH=OFF
if grep -q 'hardsphere_\(readers\|program\|tool\)\.dir/Unity' "$work/unity/compile_commands.json"; then
  fail "CMAKE_UNITY_BUILD makes the program of large units"
fi

# The .pc file finds headers and libraries, however their folders are named. CMake takes no folder of headers in the sources.
outside=$(mktemp -d)
trap 'rm -rf "$outside"' EXIT
packaged() { # name, prefix, folder of libraries, folder of headers, options
  local name=$1 prefix=$2 libraries=$3 headers=$4
  shift 4
  configure "$name" "$source" -DCMAKE_INSTALL_PREFIX="$prefix" -DHSP_COMPONENTS= -DHSP_TESTS=OFF -DHSP_BENCH=OFF \
    -DHSP_FORTRAN=OFF "$@"
  mkdir -p "$libraries/pkgconfig" "$headers"
  mv "$work/$name/hardsphere.pc" "$libraries/pkgconfig"
  for pair in "libdir:$libraries" "includedir:$headers" "module_source:$headers/hardsphere/hardsphere.f90"; do
    found=$(PKG_CONFIG_PATH=$libraries/pkgconfig pkg-config --variable="${pair%%:*}" hardsphere)
    [ "$(realpath -m "$found")" = "$(realpath -m "${pair#*:}")" ] || fail "$name: ${pair%%:*} is $found, not ${pair#*:}"
  done
}
packaged folders_below "$work/p" "$work/p/lib64" "$work/p/include" -DCMAKE_INSTALL_LIBDIR="$work/p/lib64"
packaged folders_apart "$work/q" "$work/lib" "$outside/include" -DCMAKE_INSTALL_LIBDIR="$work/lib" \
  -DCMAKE_INSTALL_INCLUDEDIR="$outside/include"
packaged headers_apart "$work/r" "$work/moved/lib/x" "$outside/include" -DCMAKE_INSTALL_LIBDIR=lib/x \
  -DCMAKE_INSTALL_INCLUDEDIR="$outside/include"
packaged libraries_apart "$work/s" "$work/lib" "$work/s/include" -DCMAKE_INSTALL_LIBDIR="$work/lib"

# A project without a build type that carries the sources and installs something of its own.
mkdir "$work/project"
cat >"$work/project/CMakeLists.txt" <<PROJECT
cmake_minimum_required(VERSION 3.21)
project(carrier LANGUAGES CXX)
add_subdirectory("$source" hardsphere)
install(FILES CMakeLists.txt DESTINATION share)
PROJECT
configure carried "$work/project"
has_flag carried -O3 || fail "carried by a project without a build type it is not optimized"
if has_flag carried -O0; then fail "carried by a project it is compiled with -O0"; fi
cmake --install "$work/carried" --prefix "$work/prefix" >"$work/install.log"
installed=$(find "$work/prefix" -type f | wc -l)
[ "$installed" -eq 1 ] || fail "carried by a project it installs $((installed - 1)) files of its own"
configure debug "$work/project" -DCMAKE_BUILD_TYPE=Debug
has_flag debug -O3 || fail "carried by a project whose build type is Debug it is not optimized"
if command -v ninja >/dev/null; then
  configure types "$work/project" -G 'Ninja Multi-Config' -DCMAKE_CONFIGURATION_TYPES='Debug;MinSizeRel'
  if grep -F "Unity/exact.cpp" "$work/types/compile_commands.json" | grep '"command"' | grep -qv -- ' -O'; then
    fail "carried by a project with several build types it is not optimized in each"
  fi
fi
configure flags "$work/project" -DCMAKE_CXX_FLAGS=-O1
if has_flag flags -O3; then fail "the project's own -O1 is overruled"; fi
rm -rf "$work"
exit $failed
