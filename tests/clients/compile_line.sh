# shellcheck shell=bash
# Compiles a client by the line that its head gives, where it is copied to, so that who copies that line can rely on it.
# To be sourced.

# compile_by_its_line SOURCE-FOLDER ARCHIVE FILE: the file and its headers come to the current folder. The answer of
# pkg-config is the source folder's headers and the archive.
compile_by_its_line() {
  local source=$1 archive=$2 file=$3 line
  cp "$source/capi/clients/$file" "$source"/capi/clients/*.h .
  line=$(grep -m 1 -oE "(mpicc|g\+\+) .*[ (]$file .*" "$file") || { echo "$file gives no line" && return 1; }
  mkdir -p answers
  printf '#!/bin/sh\n[ "$*" = "--cflags --libs hardsphere" ] && echo "-I%s/include %s -lm"\n' "$source" "$archive" \
    >answers/pkg-config
  chmod +x answers/pkg-config
  PATH=$PWD/answers:$PATH bash -euc "${line%%\*/}" || { echo "$line" && return 1; }
}
