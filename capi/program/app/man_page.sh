#!/usr/bin/env bash
# Writes the manual page from what the program says about itself:
#   bash capi/program/app/man_page.sh PROGRAM > hardsphere.1
# So it is installed.
set -euo pipefail
program=$1
export LC_ALL=C

text() { # help as it is, with the characters that roff would take for its own
  sed -e 's/\\/\\e/g' -e "s/^[.']/\\\\\&&/" -e 's/-/\\-/g'
}
commands=$("$program" --help | sed -n 's/^  hardsphere \([a-z]*\) .*FILE.*/\1/p')
version=$("$program" --version)
printf '.TH HARDSPHERE 1 "" "%s" "User Commands"\n' "$version"
printf '.SH NAME\nhardsphere \\- exact geometry of unions of balls (molecules)\n'
printf '.SH DESCRIPTION\n.nf\n'
"$program" --help | sed 1,2d | text
printf '.fi\n'
for command in $commands; do
  printf '.SH HARDSPHERE %s\n.nf\n' "${command^^}"
  # The common part of all commands stands above.
  "$program" "$command" --help | sed '/^FILE is /,$d' | sed -e :a -e '/^\n*$/{$d;N;ba' -e '}' | text
  printf '.fi\n'
done
printf '.SH EXAMPLES\n.nf\n'
text <<'EXAMPLES'
hardsphere measure 1crn.pdb --probe 1.4 --by residue
hardsphere voids 1crn.pdb --probe 1.4 --json
hardsphere mesh 1crn.pdb --probe 1.4 --edge 0.3 -o crambin.ply
hardsphere map 1crn.pdb --view 1,0,0 --per-ball
hardsphere draw 1crn.pdb -o crambin.svg --rotate 0,90,0
hardsphere measure *.cif --no-water --probe 1.4 --csv --by chain > chains.csv
gunzip -c 1crn.pdb.gz | hardsphere measure - --format pdb --no-water --pdb-out - > areas.pdb
EXAMPLES
printf '.fi\n'
