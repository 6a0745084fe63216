#!/usr/bin/env bash
# The structs that hardsphere.h and the headers in the folder of its name define, one a line, sorted:
#   name type:field type:field(length) ...
#   header_structs.sh HEADER C-COMPILER
set -euo pipefail
bash "$(dirname "$0")/header_text.sh" "$1" | "$2" -x c -std=c99 -E -P - | tr '\n' ' ' |
  grep -oE 'typedef struct hsp_[a-z_]+ \{[^}]*\}' |
  awk '{
    name = $3
    sub(/^[^{]*\{/, ""); sub(/\}$/, "")
    line = name
    count = split($0, fields, ";")
    for (i = 1; i <= count; ++i) {
      if (split(fields[i], word, " ") < 2) continue
      field = word[2]; gsub(/\[/, "(", field); gsub(/\]/, ")", field)
      line = line " " word[1] ":" field
    }
    print line
  }' | LC_ALL=C sort
