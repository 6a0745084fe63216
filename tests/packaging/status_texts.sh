#!/usr/bin/env bash
# The meaning of a status stands in the header, in hsp_status_text and in the table of the guide: word for word the
# same.
#   status_texts.sh SOURCE-FOLDER
set -euo pipefail
source=$1
header=$(sed -nE 's|^#define (HSP_OK\|HSP_E_[A-Z_]+) +\(?(-?[0-9]+)\)? +/\*\*< (.*) \*/$|\1 \2 \3|p' "$source/include/hardsphere/status.h")
[ "$(wc -l <<<"$header")" -ge 11 ] || { echo "the header's statuses were not found" && exit 1; }
texts=$(awk '/^ *case HSP_/ { sub(/^ *case /, ""); sub(/:$/, ""); name = $0 }
  /^ *return "/ && name != "" { sub(/^ *return "/, ""); sub(/";$/, ""); print name, $0; name = "" }' "$source/capi/shims/core/hsp_status.cpp")
table=$(sed -nE 's/^\| `(HSP_OK|HSP_E_[A-Z_]+)` \| (-?[0-9]+) \| (.*) \|$/\1 \2 \3/p' "$source/capi/guide/guarantees.md")
diff -u --label status.h --label guarantees.md <(echo "$header") <(echo "$table")
diff -u --label status.h --label hsp_status_text <(sed -E 's/^([A-Z_]+) -?[0-9]+ /\1 /' <<<"$header") <(echo "$texts")
echo "$(wc -l <<<"$header") statuses"
