#!/usr/bin/env bash
# capi/clients/openmm_sasa.cpp: forces of the context against quotients of its energy, and the total energy kept, the
# better the smaller the time step, in open space and in a periodic box.
#   openmm.sh SOURCE-FOLDER ARCHIVE WORK-FOLDER C++-COMPILER
# Exit status 77: OpenMM 7 is missing here; package libopenmm-dev.
set -euo pipefail
source=$1 archive=$2 work=$3 cxx=$4
here=$(cd "$(dirname "$0")" && pwd)
# shellcheck source=compile_line.sh
. "$here/compile_line.sh"
rm -rf "$work"
mkdir -p "$work"
cd "$work"
printf '#include <openmm/reference/ReferencePlatform.h>\n' >probe.cpp
"$cxx" -std=c++17 -c probe.cpp 2>/dev/null || { echo "skipped: there is no OpenMM here" && exit 77; }
compile_by_its_line "$source" "$archive" openmm_sasa.cpp
for box in "" " box"; do
  for run in "2.26 0.004 200$box" "2.26 0.001 800$box"; do
    read -ra words <<<"$run"
    ./openmm_sasa "${words[@]}"
  done >printed
  awk '{ if (!($1 < 1e-4 && $2 > 1)) bad = 1; away[NR] = $3 }
    END { exit !(NR == 2 && !bad && away[2] < away[1] / 3 && away[2] < 0.01) }' printed || { cat printed && exit 1; }
  echo "worst difference, largest force, energy goes by, of two time steps$box:" $(cat printed)
done
