#!/usr/bin/env bash
# Arrows between the rooms run downward only.
#   include_direction.sh SOURCE-FOLDER
set -euo pipefail
cd "$1"
# A room may include itself and the rooms before it.
order="core exact model grid boundary topology measure view picture"
failed=0
files=0

complain() {
  echo "$1"
  failed=1
}

place() {
  local position=0 room
  for room in $order; do
    position=$((position + 1))
    if [ "$room" = "$1" ]; then
      echo $position
      return
    fi
  done
  echo 0
}

for folder in lib/*/; do
  [ "$(place "$(basename "$folder")")" -gt 0 ] || complain "$folder: a room without a place in the order"
done

while read -r file; do
  files=$((files + 1))
  room=$(echo "$file" | cut -d/ -f2)
  while read -r included; do
    other=${included%%/*}
    if [ "$other" = "$included" ]; then
      complain "$file includes \"$included\": lib/ names its own headers by room"
    elif [ "$(place "$other")" -eq 0 ]; then
      complain "$file includes \"$included\": no room of lib/"
    elif [ "$(place "$other")" -gt "$(place "$room")" ]; then
      complain "$file includes \"$included\": $room comes before $other"
    elif [ ! -e "lib/$included" ]; then
      complain "$file includes \"$included\": no such file"
    fi
  done < <(sed -n 's/^[[:space:]]*#[[:space:]]*include[[:space:]]*"\([^"]*\)".*/\1/p' "$file")
  if grep -nE '#[[:space:]]*include[[:space:]]*[<"](hardsphere|hsp_)' "$file"; then
    complain "$file: lib/ does not know the C interface"
  fi
done < <(find lib -name '*.hpp' -o -name '*.cpp' | sort)

# Nobody includes the entry points' headers, and users' code knows the public header alone.
for header in capi/*.hpp; do
  [ -e "$header" ] || continue
  name=$(basename "$header")
  if grep -rnE "#[[:space:]]*include[[:space:]]*[<\"]([^\"]*/)?$name" lib tests bench fuzz capi/tool capi/examples 2>/dev/null; then
    complain "$name is for capi/*.cpp alone"
  fi
done
if grep -rnE '#[[:space:]]*include[[:space:]]*"('"${order// /|}"')/' capi/tool capi/examples tests/api tests/program 2>/dev/null; then
  complain "programs and interface tests go through hardsphere.h"
fi

[ $files -gt 0 ] || complain "no file found in lib/"
[ $failed -eq 0 ] && echo "$files files of lib/ include downward only"
exit $failed
