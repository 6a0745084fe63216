#!/usr/bin/env bash
# Completion in shells: by the script that the program writes bash finds commands, options and the words behind them.
#   completion.sh PROGRAM
set -euo pipefail
bash_script=$("$1" completion bash) zsh_script=$("$1" completion zsh)
if command -v zsh >/dev/null; then zsh -n <<<"$zsh_script"; fi

# shellcheck disable=SC1091
source /dev/stdin <<<"$bash_script"
failed=0
# The command line so far, its last word being completed; then what is to be offered.
expect() {
  read -ra COMP_WORDS <<<"$1"
  if [ "${1% }" != "$1" ]; then COMP_WORDS+=(""); fi
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
  _hardsphere || true # it ends with what compgen found
  if [ "${COMPREPLY[*]-}" != "$2" ]; then
    echo "hardsphere completes '$1' by '${COMPREPLY[*]-}', not by '$2'" && failed=1
  fi
}
expect "hardsphere mea" "measure"
expect "hardsphere c" "contacts complex cells clash completion"
expect "hardsphere help dr" "draw"
expect "hardsphere completion " "bash zsh"
expect "hardsphere voids x.pdb --m" "--model --models --min-volume"
expect "hardsphere measure x.pdb --g" "--gradient"
expect "hardsphere draw x.pdb --style " "flat headlight soft"
expect "hardsphere contacts x.pdb --by r" "residue"
expect "hardsphere model --radii p" "protor"
expect "hardsphere path --format c" "cif"
expect "hardsphere mesh x.pdb --surface s" "sas ses"
expect "hardsphere measure x.p" "" # names of files: bash's own
# Texts go on behind the point of a file's name, and end at a full stop.
for text in '*--pdb-out=[write the .pdb file again with the free area of each atom in columns 61-66]:FILE:_files' \
  '*--profile=[also a chart of the tunnels]:OUT.svg:_files' '*--cells[also volume, free area and contact area of every'; do
  grep -qF -- "'$text" <<<"$zsh_script" || { echo "hardsphere.zsh has no '$text'" && failed=1; }
done
exit $failed
