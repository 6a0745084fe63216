#!/usr/bin/env bash
# The manual page says what the program says, and is a page that can be formatted.
#   man_page.sh MAN_PAGE.SH PAGE PROGRAM
set -euo pipefail
diff -u --label "$2" --label "what $1 writes" "$2" <(bash "$1" "$3")
if command -v groff >/dev/null; then
  warnings=$(groff -man -Tutf8 -ww -rLL=130n "$2" 2>&1 >/dev/null)
  [ -z "$warnings" ] || { echo "$warnings" && exit 1; }
fi
