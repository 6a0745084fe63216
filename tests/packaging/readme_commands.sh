#!/usr/bin/env bash
# Every command line with the program that README.md and the pages of capi/guide show, and every example in its help and its manual page, runs
# as it stands there: exit status 0, nothing on stderr, results on stdout or in the files that it names, and no other files.
#   readme_commands.sh own|further SOURCE-FOLDER WORK-FOLDER PROGRAM [FOLDER-OF-FURTHER-MOLECULES]
# Lines that write pictures of the gallery are left out: gallery.sh runs them.
# own: those on files that the project has, under the names that people know; further: those on molecules in the folder
# HSP_MOLECULES, or else in the one given. If one is not there its lines are named, and the exit status is 77.
set -euo pipefail
which=$1 source=$2 work=$3 program=$4 further=${HSP_MOLECULES:-${5:-}}
rm -rf "$work"
mkdir -p "$work/bin" "$work/files"
ln -s "$program" "$work/bin/hardsphere"
PATH=$work/bin:$PATH

# The contents of the lines.
molecules=$source/bench/molecules inputs=$source/tests/program/inputs/good
cp "$molecules"/{crambin,caffeine,acetyl_coa,ubiquitin}.pdb "$work/files"
cp "$molecules/crambin.pdb" "$work/files/1crn.pdb"
gzip -c "$molecules/crambin.pdb" >"$work/files/1crn.pdb.gz"
awk '/^(ATOM|HETATM)/ { print 1 + NR % 3 }' "$molecules/crambin.pdb" >"$work/files/sigma.txt"
cp "$inputs/one.cif" "$work/files"
cp "$inputs/one.cif" "$work/files/other.cif"
cp "$inputs/crystal.cif" "$work/files/irmof1.cif"
cp "$inputs/residues.gro" "$work/files/frame.gro"
cp "$inputs/../crambin.xtc" "$work/files/run.xtc"
awk '/^ATOM/ { print substr($0, 31, 8), substr($0, 39, 8), substr($0, 47, 8), 1.7 }' "$molecules/crambin.pdb" >"$work/files/crambin.xyzr"
foreign=(4hhb.pdb)

# Lines of code in the pages and code within their text; in the summary of commands FILE and X,Y,Z stand for something,
# and three blanks end a line. Lines with variables of the shell are for machines that are not here.
pages=("$source/README.md" "$source"/capi/guide/*.md)
{
  awk '/^```/ { block = !block; next }
       (block || /^    /) && !/\$/ && /^ *([a-z][^|]*\| )?hardsphere [-a-z]/ { print }' "${pages[@]}" |
    sed -E -e 's/^ +//' -e 's/ {3,}.*//'
  # shellcheck disable=SC2016 # these are Markdown's
  grep -oh '`hardsphere [^`]*`' "${pages[@]}" | tr -d '`'
  hardsphere --help | sed -n 's/^  hardsphere \([a-z]*\) .*FILE.*/\1/p' | while read -r command; do
    hardsphere "$command" --help | sed -n 's/^Example: //p'
  done
  bash "$source/capi/program/app/man_page.sh" hardsphere | sed -n '/^\.SH EXAMPLES/,$p' | grep hardsphere | sed 's/\\-/-/g'
} | sed -e 's/\<FILE\>/1crn.pdb/g' -e 's/\<x\.\(pdb\|xyzr\)\>/crambin.\1/g' -e 's/ A:B/ 1:2/' -e 's/X,Y,Z/10,10,10/g' -e 's/X,Y/10,12/' \
  -e 's/\<OUT\.svg/out.svg/' | sort -u >"$work/lines"
# Fewer would mean that they are written in another way now, and not found.
[ "$(wc -l <"$work/lines")" -ge 25 ] || { cat "$work/lines" && echo "are all the lines that were found" && exit 1; }
for command in model boundary measure voids pores query clash mesh map pick draw; do
  grep -q "hardsphere $command 1crn" "$work/lines" || { echo "no page shows hardsphere $command" && exit 1; }
done

fail() {
  echo "\$ $line"
  cat "$work/err"
  echo "$1"
  exit 1
}

# The files that a line says it writes, one on each line.
written() {
  local pictures
  pictures=$(grep -oE -e '--spin [0-9]+' <<<"$1" | sed 's/.* //' || true)
  if [ -n "$pictures" ]; then
    local out
    out=$(grep -oE -e '-o [^ ]+' <<<"$1" | sed 's/.* //')
    seq -f "${out%.*}-%03g.${out##*.}" 0 $((pictures - 1))
    return
  fi
  grep -oE '(> |-o |--output[ =]|--pdb-out[ =]|--map[ =]|--points[ =]|--tunnels-out[ =]|--profile[ =]|--tree[ =]|--plot[ =])[^ ]+' <<<"$1" | sed 's/.*[ =]//' | grep -vx -e - |
    sed -E 's/(.*)\.vert$/&\n\1.face/' | sort -u || true
}

run() { # in a folder of its own
  local folder=$work/run
  rm -rf "$folder"
  cp -r "$work/files" "$folder"
  (cd "$folder" && bash -o pipefail -c "$line" </dev/null >"$work/out" 2>"$work/err") || fail "its exit status is $?"
  [ ! -s "$work/err" ] || fail "it writes on stderr"
  written "$line" >"$work/expected"
  diff "$work/expected" <(comm -13 <(ls "$work/files") <(ls "$folder")) || fail "these are not the files that it names"
  while read -r file; do
    [ -s "$folder/$file" ] || fail "$file is empty"
  done <"$work/expected"
  [ -s "$work/out" ] || grep -q ' > ' <<<"$line" || fail "it prints nothing"
}

export LC_ALL=C
{
  ls "$source/tests/program/pictures"
  grep -oE '[^ ]+$' "$source/tests/program/pictures/digests.txt"
} >"$work/drawn"
ran=0 missing=0
while read -r line; do
  if written "$line" | grep -qxF -f "$work/drawn"; then continue; fi
  kind=own
  for name in "${foreign[@]}"; do
    if grep -qwF -- "$name" <<<"$line"; then
      kind=further
      [ "$which" != further ] || [ -e "$work/files/$name" ] || [ ! -e "$further/$name.gz" ] ||
        gzip -dc "$further/$name.gz" >"$work/files/$name"
      [ -e "$work/files/$name" ] || kind=${kind/further/missing}
    fi
  done
  if [ "$which" = further ] && [ "$kind" = missing ]; then
    echo "left out, there is no such file here: $line"
    missing=$((missing + 1))
  elif [ "$which" = "$kind" ]; then
    run
    echo "$line"
    ran=$((ran + 1))
  fi
done <"$work/lines"
echo "$ran lines ran, $missing were left out"
[ $missing -eq 0 ] || exit 77
[ $ran -gt 0 ] || exit 1
rm -rf "$work"
