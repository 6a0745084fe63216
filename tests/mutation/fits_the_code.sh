#!/usr/bin/env bash
# Holds mutations.txt and the lists of explained exceptions against the code, and survivors.txt against mutations.txt.
# Builds nothing.
#   fits_the_code.sh SOURCE-FOLDER
set -euo pipefail
source=$1
here=$source/tests/mutation
export LC_ALL=C

# Every mutation can be made: its text stands in its file exactly once.
status=0
awk -v root="$source" -f "$here/mutations.awk" "$here/mutations.txt" || status=1

# Every survivor is explained, and nothing else is.
differ() { # what, expected, found
  if diff <(echo "$2") <(echo "$3") | sed -n "s/^</$1 lacks/p; s/^>/$1 has too much:/p" | grep .; then status=1; fi
}
differ survivors.txt "$(sed -nE 's/^([a-z][0-9]+) [^ ]+ survived$/\1/p' "$here/mutations.txt" | sort)" \
  "$(sed -nE 's/^([a-z][0-9]{2,3}) .*/\1/p' "$here/survivors.txt" | sort)"

# Each explained exception stands in the code, whatever its white space.
stands() { # list, what separates the file, the text and the rest
  awk -F "$2" -v root="$source/" -v list="$1" '
    /^#/ { next }
    !($1 in code) { while ((getline line <(root $1)) > 0) code[$1] = code[$1] line; gsub(/[ \t]/, "", code[$1]) }
    { text = $2; gsub(/[ \t]/, "", text) }
    !index(code[$1], text) { print list ": " $1 " does not have " $2; status = 1 }
    END { exit status }' "$source/tests/$1" || status=1
}
stands coverage/conditions.txt ' [|] '
stands mutation/drawn/explained.txt '\t'
exit $status
