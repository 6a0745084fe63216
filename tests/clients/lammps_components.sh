#!/usr/bin/env bash
# capi/clients/lammps_components.c: the same bytes with 1, 2, 4 and 8 ranks, and what the program finds of the same atoms in one
# piece, from the text that LAMMPS writes.
#   lammps_components.sh SOURCE-FOLDER ARCHIVE WORK-FOLDER PROGRAM
# Exit status 77: LAMMPS's library or MPI is missing here; packages lammps, liblammps-dev, openmpi-bin, libopenmpi-dev.
set -euo pipefail
source=$1 archive=$2 work=$3 program=$4
here=$(cd "$(dirname "$0")" && pwd)
# shellcheck source=compile_line.sh
. "$here/compile_line.sh"
enter_with_lammps "$source" "$work" lammps_components.c
compile_by_its_line "$source" "$archive" lammps_components.c

input() { # boundary: atoms of two types at random, in a box of 50 angstroms
  printf '%s\n' 'units real' "boundary $1" 'atom_style atomic' 'atom_modify map array' \
    'region box block 0 50 0 50 0 50' 'create_box 2 box' 'create_atoms 1 random 2800 4711 box' \
    'create_atoms 2 random 1400 815 box' 'mass * 14' 'pair_style zero 3.0' 'pair_coeff * *' \
    'write_dump all custom atoms.dump type x y z modify format float %.17g'
}
input 'f f f' >atoms.in
input 'p f f' >periodic.in
for ranks in 1 2 4 8; do
  mpirun -n $ranks ./found atoms.in 2.0 1.25 >out.$ranks 2>log || { cat log && exit 1; }
  cmp out.1 out.$ranks
  grep -qE "^$ranks ranks, [0-9]+ ghosts, [0-9]+ bytes" log
done
grep -qE '^8 ranks, [1-9][0-9]+ ghosts, [1-9][0-9]+ bytes' log
if mpirun -n 2 ./found periodic.in 2.0 1.25 >refused 2>log; then exit 1; fi
grep -q "must not be periodic" log
if grep -q . refused; then exit 1; fi

sed '1,/^ITEM: ATOMS/d' atoms.dump | awk '{ print $2, $3, $4, $1 == 1 ? 2.0 : 1.25 }' >atoms.xyzr
"$program" measure --json atoms.xyzr >whole.json
"$program" boundary --json atoms.xyzr >>whole.json
number() { grep -m 1 -oE "\"$1\": *[^,}]+" whole.json | sed 's/.*: *//'; }
awk -v area="$(number area)" -v volume="$(number volume)" -v components="$(number components)" -v voids="$(number voids)" \
  -v euler="$(number euler)" \
  -F '[ ,]+' '{
    off = ($11 / area - 1)^2 + ($13 / volume - 1)^2
    if (!($1 == 4200 && $3 == components && $5 == voids && $9 == euler && components > 20 && voids > 10 && off < 1e-24)) {
      print "in one piece: area " area ", volume " volume ", components " components ", voids " voids ", Euler number " euler
      exit 1
    }
  }' out.1
echo "$(cat out.1); $(tail -n 1 log)"
