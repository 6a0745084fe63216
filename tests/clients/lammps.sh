#!/usr/bin/env bash
# capi/clients/lammps_sasa.c: the same bits of areas and forces with 1, 2 and 4 ranks, forces against difference quotients
# of the energy, and the total energy kept, the better the smaller the time step.
#   lammps.sh SOURCE-FOLDER ARCHIVE WORK-FOLDER
# Exit status 77: LAMMPS's library or MPI is missing here; packages lammps, liblammps-dev, openmpi-bin, libopenmpi-dev.
set -euo pipefail
source=$1 archive=$2 work=$3
here=$(cd "$(dirname "$0")" && pwd)
# shellcheck source=compile_line.sh
. "$here/compile_line.sh"
enter_with_lammps "$source" "$work" lammps_sasa.c
compile_by_its_line "$source" "$archive" lammps_sasa.c

for ranks in 1 2 4; do
  mpirun -n $ranks ./lammps_sasa 0.0072 bits 2>log | sort >bits.$ranks
done
[ "$(wc -l <bits.1)" -eq 512 ] && [ "$(awk '$4 != "0x0p+0"' bits.1 | wc -l)" -gt 100 ]
cmp bits.1 bits.2
cmp bits.1 bits.4
./lammps_sasa 0.0072 quotients >quotients
awk '{ if (!($1 < (NR == 1 ? 1e-7 : 5e-3) && $2 > (NR == 1 ? 0.01 : 100))) bad = 1 } END { exit bad || NR != 2 }' quotients ||
  { echo "forces, virial:" && cat quotients && exit 1; }
# Spheres that come to touch, or cease to, change a force at once: the error falls with the step, not with its square.
for run in "4 480" "2 960" "1 1920"; do
  read -ra words <<<"$run"
  ./lammps_sasa 0.0072 run "${words[@]}"
done >kept
awk '{ rms[NR] = $1 } END { exit !(NR == 3 && rms[1] > rms[3] * 3 && rms[2] > rms[3] && rms[3] < 0.02) }' kept ||
  { echo "the total energy goes by" && cat kept && exit 1; }
echo "512 atoms, the same bits with 1, 2 and 4 ranks; quotients" $(cat quotients) "energy goes by" $(cat kept)
