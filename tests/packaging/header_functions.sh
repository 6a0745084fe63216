#!/usr/bin/env bash
# The functions that the headers declare, one a line, sorted: from the record of them in capi/abi.
#   header_functions.sh SOURCE-FOLDER
set -euo pipefail
sed -nE '/^HSP_|^typedef/d; s/^.*[ *](hsp_[a-z0-9_]+)\(.*$/\1/p' "$1/capi/abi/functions.txt" | LC_ALL=C sort
