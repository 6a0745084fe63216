#!/usr/bin/env bash
# The functions that the header declares, one a line, sorted.
#   header_functions.sh HEADER
set -euo pipefail
tr '\n' ' ' <"$1" | grep -oE 'HSP_API [^;]*;' | grep -oE 'hsp_[a-z0-9_]+\(' | tr -d '(' | LC_ALL=C sort
