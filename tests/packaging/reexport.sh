#!/usr/bin/env bash
# A static library that uses hardsphere inside and is itself exported: it can be configured whether hardsphere is
# installed with it or not, and a program that finds it, where it was built or installed, links and runs.
#   reexport.sh SOURCE-FOLDER WORK-FOLDER C-COMPILER C++-COMPILER
set -euo pipefail
source=$1 work=$2 cc=$3 cxx=$4
projects=$(cd "$(dirname "$0")" && pwd)/consumers/reexport
rm -rf "$work"
mkdir -p "$work"
step() {
  "$@" >"$work/log" 2>&1 || { cat "$work/log" && exit 1; }
}
use() { # name, options
  local name=$1
  shift
  step cmake -S "$projects/user" -B "$work/$name" -DCMAKE_C_COMPILER="$cc" "$@"
  step cmake --build "$work/$name"
  "$work/$name/user" || { echo "$name: no bytes" && exit 1; }
}
for installs in ON OFF; do
  step cmake -S "$projects" -B "$work/$installs" -DHARDSPHERE_SOURCE="$source" -DHSP_INSTALL=$installs -DHSP_COMPONENTS= \
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O0 -DCMAKE_C_COMPILER="$cc" -DCMAKE_CXX_COMPILER="$cxx"
done
step cmake --build "$work/ON" --parallel 2
step cmake --install "$work/ON" --prefix "$work/prefix"
use built -DWHERE=built -DHOST="$work/ON"
use installed -DWHERE=installed -DCMAKE_PREFIX_PATH="$work/prefix"
rm -rf "$work"
