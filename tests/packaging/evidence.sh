#!/usr/bin/env bash
# lib/EVIDENCE.md has the rows of tests/evidence/requirements.txt, with their words, and all of them hold.
#   evidence.sh SOURCE-FOLDER
set -euo pipefail
cd "$1"
diff <(grep -v '^#' tests/evidence/requirements.txt | awk -F ' *[|] *' '{ print $1 "|" $2 "|" $3 }') \
  <(sed -n '/^| row /,$p' lib/EVIDENCE.md | awk -F ' *[|] *' '/^\|/ && $2 != "row" && $2 !~ /^-/ { print $2 "|" $3 "|" $4 }') ||
  { echo "bash tests/evidence/run.sh --write makes lib/EVIDENCE.md anew" && exit 1; }
rows=$(grep -c '| holds |$' lib/EVIDENCE.md)
[ "$rows" -eq "$(grep -vc '^#' tests/evidence/requirements.txt)" ] || { echo "only $rows rows hold" && exit 1; }
echo "$rows rows"
