#!/usr/bin/env bash
# The functions that hardsphere.h and the headers in the folder of its name declare, one a line, sorted.
#   header_functions.sh HEADER
set -euo pipefail
bash "$(dirname "$0")/header_text.sh" "$1" | tr "\n" " " | grep -oE "HSP_API [^;]*;" | grep -oE "hsp_[a-z0-9_]+\(" | tr -d "(" | LC_ALL=C sort
