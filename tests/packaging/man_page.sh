#!/usr/bin/env bash
# The manual page has a section for each command that the program has, with its options, and can be formatted.
#   man_page.sh MAN_PAGE.SH PROGRAM
set -euo pipefail
page=$(bash "$1" "$2")
commands=$("$2" --help | sed -n 's/^  hardsphere \([a-z]*\) .*FILE.*/\1/p')
[ "$(wc -w <<<"$commands")" -ge 16 ] || { echo "few commands: $commands" && exit 1; }
for command in $commands; do
  grep -qx ".SH HARDSPHERE ${command^^}" <<<"$page" || { echo "the page has no $command" && exit 1; }
  for option in $("$2" "$command" --help | grep -oE '^  --[a-z-]+'); do
    grep -qF -- "${option//-/\\-}" <<<"$page" || { echo "the page has no $option of $command" && exit 1; }
  done
done
if command -v groff >/dev/null; then
  warnings=$(groff -man -Tutf8 -ww -rLL=130n <<<"$page" 2>&1 >/dev/null)
  [ -z "$warnings" ] || { echo "$warnings" && exit 1; }
fi
