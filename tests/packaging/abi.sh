#!/usr/bin/env bash
# The record of the binary interface in capi/abi, which is generated from the headers, against compilers:
# declarations, values of constants, sizes of structs and offsets of fields, which are those of every target. clang,
# where it is there, compiles them as assertions for a list of targets.
#   abi.sh SOURCE-FOLDER WORK-FOLDER C-COMPILER
# `bash capi/interface/generate.sh` makes the record anew. Changes that a release may make to that are in
# capi/abi/README.md.
set -euo pipefail
source=$(cd "$1" && pwd) work=$2 cc=$3
targets="x86_64-linux-gnu i386-linux-gnu x86_64-windows-msvc aarch64-linux-gnu arm64-apple-macos thumbv6m-none-eabi
  thumbv7em-none-eabihf armv7-linux-gnueabihf riscv32-none-elf riscv64-linux-gnu powerpc64le-linux-gnu s390x-linux-gnu
  mips-linux-gnu mips64el-linux-gnuabi64 wasm32-wasi"
rm -rf "$work"
mkdir -p "$work"
cd "$source/capi/abi"
{
  printf '#include "%s/include/hardsphere.h"\n#include <stddef.h>\n' "$source"
  # A declaration that is not the header's is an error.
  sed '/^#/d; /^HSP_/d; s/$/;/' functions.txt
  awk '!/^#/ { print "_Static_assert(" $1 " == " $2 ", \"" $1 "\");" }' constants.txt
  awk '/^#/ { next }
    { gsub("[0-9]+/[0-9]+", "(sizeof(void *) == 8 ? &)", $2); sub("/", " : ", $2) }
    NF == 2 { print "_Static_assert(sizeof(" $1 ") == " $2 ", \"" $1 "\");"; next }
    $3 == "function*" { $3 = "void (*)(void)" }
    { split($1, part, ".")
      print "_Static_assert(offsetof(" part[1] ", " part[2] ") == " $2 ", \"" $1 "\");"
      field = "((" part[1] " *)0)->" part[2]
      print "_Static_assert(sizeof(" field ") == " $4 " * sizeof(" $3 "), \"" $1 "\");" }' structs.txt
} >"$work/asserted.c"
[ "$(grep -c sizeof "$work/asserted.c")" -gt 600 ] || { echo "capi/abi is not read" && exit 1; }

# Declarations of the stable tier in the last release, from 1.0 on, stay there.
if [ -e frozen.txt ]; then
  for file in functions constants structs; do awk '/^#/ { ++part; next } part == 1' $file.txt; done | LC_ALL=C sort >"$work/stable"
  LC_ALL=C comm -23 frozen.txt "$work/stable" >"$work/gone"
  [ ! -s "$work/gone" ] || { cat "$work/gone" && echo "are promised, and gone or changed" && exit 1; }
fi

failed=0 compared=0
expect() { # what it is for, compiler and its options
  local target=$1
  shift
  "$@" -std=c11 -fsyntax-only "$work/asserted.c" 2>"$work/errors" || {
    echo "$target:"
    head -n 5 "$work/errors"
    failed=1
  }
}
expect "this machine" "$cc" -Werror
clang=$(command -v clang-14 || command -v clang || true)
for target in ${clang:+$targets}; do
  compared=$((compared + 1))
  expect "$target" "$clang" --target="$target" -ffreestanding -nostdlibinc
done
[ $failed -eq 0 ] || { echo "see capi/abi/README.md" && exit 1; }
echo "$(grep -vc '^#' functions.txt) declarations, $(grep -vc '^#' constants.txt) constants," \
  "$(awk '!/^#/ && NF == 2' structs.txt | wc -l) structs, $compared further targets"
