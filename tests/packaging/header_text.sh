#!/usr/bin/env bash
# The text of the interface: hardsphere.h and the headers in the folder of its name, one after the other, without the lines
# in which they include each other and the standard's.
#   header_text.sh HEADER
set -euo pipefail
cat "$1" "${1%.h}"/*.h | grep -v '^ *# *include'
