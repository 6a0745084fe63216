#!/usr/bin/env bash
# The text of a program that asks for the balls around a point and nothing else, and of README's first program: all bytes
# that they link.
#   link_size.sh INSTALL-PREFIX WORK-FOLDER C-COMPILER
# By pkg-config the linker leaves out all functions that are not called; by hand, without its option, all objects.
set -euo pipefail
prefix=$1 work=$2 cc=$3
here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$work"
mkdir -p "$work"
export PKG_CONFIG_PATH
PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name hardsphere.pc)")
read -ra flags <<<"$(pkg-config --cflags hardsphere)"
read -ra package <<<"$(pkg-config --libs hardsphere)"
by_hand=("-L$(pkg-config --variable=libdir hardsphere)" -lhardsphere -lm)
failed=0
link() { # how, its source, bytes at most, what stands behind the source
  local how=$1 source=$2 most=$3 text
  shift 3
  "$cc" -std=c99 -O2 "${flags[@]}" -o "$work/$how" "$source" "$@"
  "$work/$how" >/dev/null
  text=$(size "$work/$how" | awk 'NR == 2 {print $1}')
  printf '%-18s %7d bytes of text, at most %d\n' "$how" "$text" "$most"
  [ "$text" -le "$most" ] || failed=1
}
awk '/^```/ { inside = $0 == "```c" && !found++; next } inside' "$here/../../README.md" >"$work/areas.c"
query=$here/consumers/one_query.c
link query-pkg-config "$query" 55500 "${package[@]}"
link query-by-hand "$query" 98500 "${by_hand[@]}"
link areas-pkg-config "$work/areas.c" 233500 "${package[@]}"
link areas-by-hand "$work/areas.c" 351500 "${by_hand[@]}"
exit $failed
