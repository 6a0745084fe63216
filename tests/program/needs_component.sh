#!/usr/bin/env bash
# The answers of a program whose library has none of its components: commands and options that need one are refused with
# status 2, one line tells why, and the rest works.
#   needs_component.sh PROGRAM INPUTS
set -euo pipefail
program=$1 water=$2/good/water.pdb
failed=0
needs() {
  local said status=0 expected="hardsphere: $1 needs the $2, which this build leaves out"
  shift 2
  said=$("$program" "$@" 2>&1) || status=$?
  if [ "$said" != "$expected" ] || [ $status -ne 2 ]; then
    printf '%s: status %d\n%s\nnot: %s\n' "$*" $status "$said" "$expected" && failed=1
  fi
}
for command in cells path gate pores; do needs $command "component space" $command "$water"; done
for command in map pick draw; do needs $command "part that draws" $command "$water"; done
needs mesh "component smooth" mesh "$water" -o -
needs "clash --rotate" "part that draws" clash "$water" "$water" --rotate 0,0,90
needs "contacts --map" "part that draws" contacts "$water" --map map.svg
needs "measure --surface" "component smooth" measure "$water" --probe 1.4 --surface ses
for command in model boundary measure voids contacts complex "query --point 0,0,0" "clash $water"; do
  # shellcheck disable=SC2086
  "$program" $command "$water" >/dev/null || failed=1
done
columns=$("$program" voids "${water%/*}/cage.xyzr")
[[ $columns == *"they need the component space"* ]] || failed=1
"$program" draw --help >/dev/null || failed=1
exit $failed
