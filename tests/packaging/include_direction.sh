#!/usr/bin/env bash
# Arrows between the rooms run downward only.
#   include_direction.sh SOURCE-FOLDER
set -euo pipefail
cd "$1"
# What each room may include besides itself and what these include: two wings stand over the boundary.
rooms="core exact model sphere boundary topology measure view picture"
declare -A over=([core]="" [exact]=core [model]=exact [sphere]=model [boundary]=sphere [topology]=boundary [measure]=topology
  [view]=boundary [picture]=view)
failed=0
files=0

complain() {
  echo "$1"
  failed=1
}

# Whether room $1 may include room $2.
allowed() {
  local room=$1
  while [ -n "$room" ]; do
    if [ "$room" = "$2" ]; then return 0; fi
    room=${over[$room]}
  done
  return 1
}

for folder in lib/*/; do
  [ -n "${over[$(basename "$folder")]+known}" ] || complain "$folder: a room without a place in the order"
done

while read -r file; do
  files=$((files + 1))
  room=$(echo "$file" | cut -d/ -f2)
  while read -r included; do
    other=${included%%/*}
    if [ "$other" = "$included" ]; then
      complain "$file includes \"$included\": lib/ names its own headers by room"
    elif [ -z "${over[$other]+known}" ]; then
      complain "$file includes \"$included\": no room of lib/"
    elif ! allowed "$room" "$other"; then
      complain "$file includes \"$included\": $room does not stand over $other"
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
if grep -rnE '#[[:space:]]*include[[:space:]]*"('"${rooms// /|}"')/' capi/tool capi/examples tests/api tests/program 2>/dev/null; then
  complain "programs and interface tests go through hardsphere.h"
fi

[ $files -gt 0 ] || complain "no file found in lib/"
[ $failed -eq 0 ] && echo "$files files of lib/ include downward only"
exit $failed
