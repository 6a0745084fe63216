#!/usr/bin/env bash
# capi/clients/lammps_fix.py with a window: LAMMPS minimises four atoms whose surface has a negative tension, so that they
# would end where spheres touch. With the area itself it stops there, at a force; with the window, from each start, at the
# one minimum, which closed forms know: a tetrahedron of which pairs overlap and no three do.
#   lammps_window.sh SOURCE-FOLDER ARCHIVE WORK-FOLDER C-COMPILER
# Exit status 77: lmp with its package PYTHON or NumPy is missing here; packages lammps, python3-numpy.
set -euo pipefail
source=$1 archive=$2 work=$3 cc=$4
here=$(cd "$(dirname "$0")" && pwd)
export LC_ALL=C PATH=/usr/bin:$PATH OMP_NUM_THREADS=1 # the Python that lmp has in it looks for its packages beside the first one
rm -rf "$work"
mkdir -p "$work/hardsphere"
cd "$work"
command -v lmp >/dev/null && grep -q python/invoke <<<"$(lmp -h)" || { echo "skipped: there is no lmp with Python here" && exit 77; }
python3 -c "import numpy" 2>/dev/null || { echo "skipped: there is no numpy here" && exit 77; }
cp "$source"/capi/python/hardsphere/*.py "$source/capi/clients/lammps_fix.py" hardsphere
python3 "$here/../python/exported.py" "$archive" hardsphere/libhardsphere.so.2 "$cc"
export PYTHONPATH=$work PYTHONDONTWRITEBYTECODE=1

minimise() { # window, seed: prints energy, that of the surface, largest force
  cat >minimise.in <<EOF
units real
atom_style atomic
atom_modify map array sort 0 0
boundary f f f
region box block -20 20 -20 20 -20 20
create_box 1 box
lattice sc 3.6
region here block 0 6.5 0 6.5 0 3 units box
create_atoms 1 region here
mass * 14.027
displace_atoms all random 0.5 0.5 0.5 $2 units box
pair_style lj/cut 10.0
pair_coeff * * 0.5 3.0
fix sasa all external pf/callback 1 1
fix_modify sasa energy yes virial yes
python surface input 1 SELF format p here "from hardsphere.lammps_fix import Surface; surface = Surface('sasa', -0.1, [1.7], probe=0, window=$1)"
python surface invoke
thermo_style custom step pe f_sasa fmax press
thermo_modify norm no format float %.12g
min_style cg
min_modify line quadratic
minimize 0 1e-6 2000 20000
print "\$(pe:%.12g) \$(f_sasa:%.12g) \$(fmax:%.12g) \$(press:%.12g)" file found
EOF
  lmp -in minimise.in -log none -screen none >log 2>&1 || { cat log && exit 1; }
  cat found
}
for window in 0.0 0.05; do
  for seed in 4711 4712 4713; do
    echo "$window $(minimise $window $seed)"
  done
done >ends

# E(d) of six pairs at the distance d: Lennard-Jones and W = (V(1.75) - V(1.65)) / 0.1, with lenses where spheres overlap.
awk '
  function lens(r, d) { return d < 2 * r ? pi * (2 * r - d) ^ 2 * (d * d + 4 * r * d) / (12 * d) : 0 }
  function volume(r, d) { return 16 / 3 * pi * r ^ 3 - 6 * lens(r, d) }
  function surface(d) { return -0.1 * (volume(1.75, d) - volume(1.65, d)) / 0.1 }
  function energy(d) { return 12 * ((3 / d) ^ 12 - (3 / d) ^ 6) + surface(d) }
  function away(a, b) { return a > b ? a - b : b - a }
  BEGIN {
    pi = atan2(0, -1)
    low = 3.3; high = 3.6
    for (k = 0; k < 200; ++k) {
      one = low + 0.382 * (high - low); other = low + 0.618 * (high - low)
      if (energy(one) < energy(other)) high = other; else low = one
    }
    least = energy(low)
  }
  $1 == 0 && $4 < 0.1 { print "the area itself is minimised: " $0; bad = 1 }
  $1 > 0 && ($4 > 1e-6 || away($2, least) > 1e-7 || away($3, surface(low)) > 1e-4 || away($5, 0) > 1e-3) {
    print "not the minimum " least ": " $0; bad = 1
  }
  $1 == 0 { stuck = stuck " " $4 }
  $1 > 0 { found = found " " $4 }
  END {
    printf "least energy %.9f at %.6f, found up to forces of%s; without a window they are%s\n", least, low, found, stuck
    exit bad || NR != 6
  }' ends || { cat ends && exit 1; }

# A window is for atoms in open space.
sed -e 's/^boundary .*/boundary p p p/' -e 's/ -20 20/ 0 9/g' minimise.in >periodic.in
if lmp -in periodic.in -log none -screen none >log 2>&1; then echo "a window in a periodic box" && exit 1; fi
grep -q "a window is for atoms in open space" log || { cat log && exit 1; }
