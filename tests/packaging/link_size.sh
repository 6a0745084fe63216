#!/usr/bin/env bash
# The text of a program that asks for the balls around a point and nothing else: all bytes that it links.
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
link() { # how, bytes at most, what stands behind the source
  local how=$1 most=$2 text
  shift 2
  "$cc" -std=c99 -O2 "${flags[@]}" -o "$work/$how" "$here/consumers/one_query.c" "$@"
  "$work/$how" >/dev/null
  text=$(size "$work/$how" | awk 'NR == 2 {print $1}')
  printf '%-10s %7d bytes of text, at most %d\n' "$how" "$text" "$most"
  [ "$text" -le "$most" ] || failed=1
}
link pkg-config 64500 "${package[@]}"
link by-hand 178500 "${by_hand[@]}"
exit $failed
