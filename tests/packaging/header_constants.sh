#!/usr/bin/env bash
# The names of the numbers that hardsphere.h and the headers in the folder of its name define, one a line, sorted. Not
# among them are macros with arguments, texts, and what decides how functions are declared.
#   header_constants.sh HEADER C-COMPILER
set -euo pipefail
echo "#include \"$1\"" | "$2" -x c -std=c99 -E -dM - |
  awk '$1 == "#define" && $2 ~ /^HSP_[A-Z0-9_]+$/ && NF > 2 && $3 !~ /^"/ && $2 != "HSP_API" {print $2}' | LC_ALL=C sort
