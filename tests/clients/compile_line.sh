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

# enter_with_lammps SOURCE-FOLDER WORK-FOLDER FILE: the empty work folder becomes the current one, where FILE has compiled without
# a warning; ends the test with status 77 where LAMMPS's library or MPI is missing.
enter_with_lammps() {
  export LC_ALL=C OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
  rm -rf "$2"
  mkdir -p "$2"
  cd "$2"
  printf '#include <lammps/library.h>\n' >probe.c
  if ! command -v mpicc >/dev/null || ! mpicc -DLAMMPS_SMALLBIG -DLAMMPS_LIB_MPI -c probe.c 2>/dev/null; then
    echo "skipped: there is no LAMMPS with MPI here" && exit 77
  fi
  mpirun -n 1 true >log 2>&1 || { echo "skipped: $(grep -m 1 . log)" && exit 77; }
  mpicc -std=c99 -Wall -Wextra -Werror -DLAMMPS_SMALLBIG -I"$1/include" -c "$1/capi/clients/$3" -o warned.o
}
