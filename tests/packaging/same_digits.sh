#!/usr/bin/env bash
# Caffeine and crambin have the same digits in C, C++, Fortran and Python: areas, volumes and gradients of all balls, as
# bits. Microcontrollers (firmware_runs.sh), WebAssembly and a page in Chromium (tests/portability) are compared with them
# in tests of their own.
#   same_digits.sh SOURCE-FOLDER LIBRARY WORK-FOLDER C-COMPILER C++-COMPILER [FORTRAN-COMPILER MODULE-FOLDER FORTRAN-ARCHIVE]
# Fortran and Python are left out where their tools are missing, and named.
set -euo pipefail
source=$1 library=$2 work=$3 cc=$4 cxx=$5 fc=${6:-} modules=${7:-} fortran=${8:-}
here=$source/tests/packaging/digits
rm -rf "$work"
mkdir -p "$work"
cd "$work"
"$cc" -std=c99 -O1 -I"$source/include" "$here/digits.c" "$library" -lm -o digits_c
"$cxx" -std=c++20 -O1 -x c++ -I"$source/include" "$here/digits.c" -x none "$library" -lm -o digits_cxx
languages='c cxx'
if [ -n "$fc" ]; then
  "$fc" -O1 -I"$modules" "$here/digits.f90" "$fortran" "$library" -lm -o digits_fortran
  languages+=' fortran'
else
  echo "Fortran is left out: there is no compiler here"
fi
if /usr/bin/python3 -c 'import cffi, setuptools' 2>/dev/null; then
  printf '#!/bin/sh\nexec /usr/bin/python3 "%s" "$1" "%s" "%s" "%s"\n' "$here/digits.py" "$source/include" \
    "$(dirname "$library")" "$source/capi/interface/hardsphere.cdef" >digits_python
  chmod +x digits_python
  languages+=' python'
else
  echo "Python is left out: there is no cffi here"
fi
for name in caffeine crambin; do
  awk 'BEGIN { radius["C"] = 1.7; radius["N"] = 1.55; radius["O"] = 1.52; radius["S"] = 1.8; radius["H"] = 1.1 }
    /^(ATOM|HETATM)/ {
      element = substr($0, 77, 2)
      gsub(/ /, "", element)
      print substr($0, 31, 8), substr($0, 39, 8), substr($0, 47, 8), radius[element]
    }' "$source/bench/molecules/$name.pdb" >$name.xyzr
  for language in $languages; do
    ./digits_$language $name.xyzr >$name.$language 2>$name.$language.log || { cat $name.$language.log && exit 1; }
    cmp $name.c $name.$language
  done
  [ "$(wc -l <$name.c)" -eq $((2 + 5 * $(wc -l <$name.xyzr))) ] || { echo "$name: too few numbers" && exit 1; }
  echo "$name: $(wc -l <$name.c) numbers have the same bits in: $languages"
done
