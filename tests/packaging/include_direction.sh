#!/usr/bin/env bash
# The rooms of lib/, the folders of the program, and their arrows: includes run downward only, and lib/README.md draws them and names every file.
#   include_direction.sh SOURCE-FOLDER           checks
#   include_direction.sh SOURCE-FOLDER --write   writes the drawing into lib/README.md, then checks
set -euo pipefail
cd "$1"
readme=lib/README.md

# The rooms that each room stands on. It may include itself, these rooms, and what these stand on. The wings smooth and
# sight both stand on the boundary, and neither knows the other. Cells of free space, paths through them and poses need
# no boundary; pores know periodic boxes, and help to find the widest path.
rooms="lanes core exact model sphere boundary measure topology contacts curvature bricks poses moving periodic numbers tangents cells paths pores pockets surface mesh"
rooms+=" view picture maps capi"
declare -A stands_on=([lanes]="" [core]="lanes" [exact]="core" [model]="exact" [cells]="model" [paths]="cells" [poses]="model" [sphere]="model"
  [boundary]="sphere" [measure]="boundary" [topology]="measure" [contacts]="measure" [curvature]="measure" [bricks]="measure" [moving]="measure" [periodic]="contacts curvature" [numbers]="exact" [tangents]="numbers model" [pores]="periodic tangents" [pockets]="pores" [surface]="measure numbers" [mesh]="surface"
  [view]="boundary" [picture]="view" [maps]="picture"
  [capi]="bricks pockets paths poses topology moving periodic mesh maps")
# The program's folders, from the command line down to the files that are read. Drawing knows tables, which do not know it.
folders="read write commands draw app"
stands_on+=([read]="" [write]="read" [commands]="write" [draw]="commands" [app]="draw")
failed=0

complain() {
  echo "$1"
  failed=1
}

# Whether room $1 may include room $2.
allowed() {
  local lower
  if [ "$1" = "$2" ]; then return 0; fi
  for lower in ${stands_on[$1]}; do
    if allowed "$lower" "$2"; then return 0; fi
  done
  return 1
}

for folder in lib/*/*/ capi/program/*/; do
  [ -n "${stands_on[$(basename "$folder")]+known}" ] || complain "$folder: a room without a place in the order"
done

# Reads every include; included["room other"] is set if a file of the room includes one of the other room.
declare -A included=()
sources=$({ find lib -name '*.hpp' -o -name '*.cpp'; find capi/shims -name '*.?pp'; find capi/program -name '*.[ch]'; } | sort)
files=$(wc -w <<<"$sources")
while IFS=: read -r file line; do
  room=capi
  if [ "${file#capi/program/}" != "$file" ]; then
    room=${file#capi/program/}
    room=${room%%/*}
    if [[ $line =~ \"hardsphere ]]; then continue; fi
  elif [ "${file#lib/}" != "$file" ]; then
    room=${file#lib/*/}
    room=${room%%/*}
    if [[ $line =~ include[[:space:]]*[\<\"](hardsphere|hsp_) ]]; then complain "$file: lib/ does not know the C interface"; fi
  fi
  [[ $line =~ \"([^\"]*)\" ]] || continue
  name=${BASH_REMATCH[1]}
  other=${name%%/*}
  if [ "$other" = "$name" ]; then
    [ "$room" = capi ] || complain "$file includes \"$name\": headers are named by their room"
  elif [ -z "${stands_on[$other]+known}" ]; then
    complain "$file includes \"$name\": no room of lib/, no folder of the program"
  elif ! allowed "$room" "$other"; then
    complain "$file includes \"$name\": $room does not stand over $other"
  elif ! compgen -G "lib/*/$name" >/dev/null && ! [ -e "capi/program/$name" ]; then
    complain "$file includes \"$name\": no such file"
  else
    included["$room $other"]=1
  fi
done < <(xargs grep -HE '^[[:space:]]*#[[:space:]]*include' <<<"$sources")
[ $files -gt 0 ] || complain "no file found in lib/"
for room in $rooms $folders; do
  for lower in ${stands_on[$room]}; do
    [ -n "${included["$room $lower"]+used}" ] || complain "the order puts $room on $lower, but no include needs that"
  done
done

# Nobody includes the entry points' headers, and users' code knows the public header alone.
for header in capi/shims/*/*.hpp; do
  [ -e "$header" ] || continue
  name=$(basename "$header")
  if grep -rnE --include='*.[ch]*' "#[[:space:]]*include[[:space:]]*[<\"]([^\"]*/)?$name" lib tests bench fuzz capi/program capi/examples 2>/dev/null; then
    complain "$name is for capi/shims alone"
  fi
done
if grep -rnE '#[[:space:]]*include[[:space:]]*"('"${rooms// /|}"')/' capi/program capi/examples tests/api tests/program 2>/dev/null; then
  complain "programs and interface tests go through hardsphere.h"
fi

# The drawing: the order from the table, and below it which room really includes which.
top_down=$(echo "$rooms" | tr ' ' '\n' | tac)
draw() {
  local room lower other
  echo
  echo '```mermaid'
  echo 'flowchart TD'
  for room in $top_down; do
    for lower in ${stands_on[$room]}; do echo "  $room --> $lower"; done
  done
  echo '```'
  echo
  echo "| includes | ${rooms// / | } |" | sed 's/ | capi |$/ |/'
  echo "|---|$(echo "${rooms% capi}" | sed 's/[a-z]* */---|/g')"
  for room in $top_down; do
    printf '| **%s** |' "$room"
    for other in ${rooms% capi}; do
      if [ "$room" != "$other" ] && [ -n "${included["$room $other"]+used}" ]; then printf ' x |'; else printf '   |'; fi
    done
    echo
  done
  echo
}
begin='<!-- The drawing is written by: bash tests/packaging/include_direction.sh . --write -->'
end='<!-- End of the drawing -->'
if [ "${2:-}" = --write ]; then
  draw >"$readme.drawing"
  awk -v begin="$begin" -v end="$end" -v drawing="$readme.drawing" '
    $0 == end { inside = 0 }
    !inside { print }
    $0 == begin { inside = 1; while ((getline line < drawing) > 0) print line }' "$readme" >"$readme.new"
  mv "$readme.new" "$readme"
  rm "$readme.drawing"
fi
if ! diff <(draw) <(awk -v begin="$begin" -v end="$end" '$0 == end { inside = 0 } inside; $0 == begin { inside = 1 }' "$readme"); then
  complain "$readme: the drawing is not that of the includes (>); bash tests/packaging/include_direction.sh . --write mends it"
fi

# The section "### room" of lib/README.md has an item for each file or for several: "- `caps`, `cap_pair`: what they are".
for room in ${rooms% capi}; do
  named=$(awk -v heading="### $room" '/^#/ { inside = $0 == heading } inside && /^- `/' "$readme" |
    sed 's/^- //; s/:.*//' | grep -o '`[^`]*`' | tr -d '`' | sort)
  present=$(find lib/*/"$room" -name '*.hpp' -o -name '*.cpp' | sed 's,.*/,,; s,[.].*,,' | sort -u)
  diff <(echo "$present") <(echo "$named") || complain "$readme: section \"### $room\" (>) does not name the files of the room (<)"
done

[ $failed -eq 0 ] && echo "$files files include downward only, as lib/README.md draws it"
exit $failed
