#!/usr/bin/env bash
# capi/clients/lammps_fix.py in the program lmp as it is installed: the same bits of forces with 1, 2 and 4 ranks and by
# threads, forces and stress against difference quotients of the energy, and the total energy kept in NVE, the better the
# smaller the time step.
#   lammps_fix.sh SOURCE-FOLDER ARCHIVE WORK-FOLDER C-COMPILER
# Exit status 77: lmp with its package PYTHON, NumPy or MPI is missing here; packages lammps, python3-numpy, openmpi-bin.
set -euo pipefail
source=$1 archive=$2 work=$3 cc=$4
here=$(cd "$(dirname "$0")" && pwd)
export LC_ALL=C OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
export PATH=/usr/bin:$PATH OMP_NUM_THREADS=1 # the Python that lmp has in it looks for its packages beside the first one
rm -rf "$work"
mkdir -p "$work/hardsphere"
cd "$work"
command -v lmp >/dev/null && grep -q python/invoke <<<"$(lmp -h)" || { echo "skipped: there is no lmp with Python here" && exit 77; }
python3 -c "import numpy" 2>/dev/null || { echo "skipped: there is no numpy here" && exit 77; }
mpirun -n 1 true >log 2>&1 || { echo "skipped: $(grep -m 1 . log)" && exit 77; }
cp "$source"/capi/python/hardsphere/*.py "$source/capi/clients/lammps_fix.py" hardsphere
python3 "$here/../python/exported.py" "$archive" hardsphere/libhardsphere.so.2 "$cc"
export PYTHONPATH=$work PYTHONDONTWRITEBYTECODE=1

# The lines of the guide, with radii and threads of the test; where ghosts have to reach farther is tried below.
page=$(awk '/^fix sasa all external/ { on = 1 } /^```/ { on = 0 } on' "$source/capi/guide/ghosts.md")
[[ $page = *", [2.0, 1.7])"* ]] && grep -qx 'comm_modify cutoff 12.0' <<<"$page"

# 512 atoms, with forces of Lennard-Jones or with none but those of the surface.
system() { # threads, pair style, its coefficients, more of Surface
  cat <<EOF
units real
atom_style atomic
atom_modify map array sort 0 0
lattice sc 4.4
region box prism 0 8 0 8 0 8 0 0 0
create_box 2 box
create_atoms 1 box
mass * 14.027
set group all type/fraction 2 0.3 4711
displace_atoms all random 0.4 0.4 0.4 4711 units box
pair_style $2 10.0
pair_coeff * * ${3:-}
neighbor 2.0 bin
neigh_modify every 1 delay 0 check yes
$(sed -e '/^comm_modify/d' -e "s/, \[2.0, 1.7\])/, [2.0, 1.6], threads=$1${4:-})/" <<<"$page")
compute stress all pressure NULL fix
thermo_style custom step etotal f_sasa c_stress[*] vol
thermo_modify norm no format float %.15g
EOF
}
run_lmp() { # ranks, name of the input
  mpirun -n "$1" lmp -in "$2" -log none -screen none -var name "$2" >"$2.log" 2>&1 || { cat "$2.log" && exit 1; }
}

# Tags depend on the number of ranks, positions do not.
for way in "1 1" "2 1" "4 1" "1 2"; do
  read -r ranks threads <<<"$way"
  system "$threads" zero >bits
  cat >>bits <<'EOF'
dump d all custom 1 dumped x y z fx fy fz
dump_modify d format float %a
run 0 post no
EOF
  run_lmp "$ranks" bits
  tail -n 512 dumped | sort >"bits.$ranks.$threads"
done
[ "$(wc -l <bits.1.1)" -eq 512 ] && [ "$(awk '$4 != "0x0p+0"' bits.1.1 | wc -l)" -gt 100 ]
for other in 2.1 4.1 1.2; do cmp bits.1.1 "bits.$other"; done

# Ghosts have to reach 6.8 and the skin: a pair style that brings fewer ends the run and says what is wanted; as far as is
# wanted, they are enough for the energy of ghosts that reach farther.
for reach in none 7.29 7.3 12.0; do
  system 1 zero | sed -e 's/^pair_style zero .*/pair_style zero 4.0/' -e 's/^neighbor .*/neighbor 0.5 bin/' >short
  [ $reach = none ] || echo "comm_modify cutoff $reach" >>short
  printf 'run 0\nprint "$(f_sasa:%%.15g)" file energy.%s\n' $reach >>short
  status=0
  lmp -in short -log none >short.log 2>&1 || status=$?
  case $reach in
    none | 7.29) [ $status -ne 0 ] && [ ! -e energy.$reach ] && grep -q 'exceeds ghost atom range' short.log &&
      grep -q 'comm_modify cutoff has to be at least 6.8 and the skin' short.log ;;
    *) [ $status -eq 0 ] ;;
  esac || { echo "ghosts that reach $reach, status $status:" && cat short.log && exit 1; }
done
cmp energy.7.3 energy.12.0

# Energies with an atom moved by 1e-4 to either side along each axis, and with the box strained as much.
number() { awk "BEGIN { printf \"%.17g\", $1 }"; }
moved() { # number, side, command there, command back
  printf '%s\nrun 0 post no\nprint "%s %s $(f_sasa:%%.17g)" append energies\n%s\n' "$3" "$1" "$2" "$4"
}
{
  system 1 zero
  echo 'group one id 31'
  echo 'run 0 post no'
  printf 'print "0 0'
  printf ' $(%s:%%.17g)' 'fx[31]' 'fy[31]' 'fz[31]' 'c_stress[1]' 'c_stress[2]' 'c_stress[3]' \
    'c_stress[4]' 'c_stress[5]' 'c_stress[6]' vol
  printf '" append energies\n'
  for side in 1 -1; do
    k=0
    for way in "1 0 0" "0 1 0" "0 0 1"; do
      read -r x y z <<<"$way"
      step() { echo "displace_atoms one move $(number "$1*$x") $(number "$1*$y") $(number "$1*$z") units box"; }
      moved $((k += 1)) $side "$(step "$side*1e-4")" "$(step "-1*$side*1e-4")"
    done
    for axis in x y z; do
      moved $((k += 1)) $side "change_box all $axis scale $(number "1+$side*1e-4") remap" \
        "change_box all $axis scale $(number "1/(1+$side*1e-4)") remap"
    done
    for axis in xy xz yz; do
      moved $((k += 1)) $side "change_box all $axis delta $(number "$side*35.2e-4") remap units box" \
        "change_box all $axis delta $(number "-1*$side*35.2e-4") remap units box"
    done
  done
} >quotients
run_lmp 1 quotients
# Pressures are in atmospheres of which 68568.415 are a kcal/mol per cubic angstrom.
awk '$1 == 0 { for (k = 1; k <= 9; ++k) known[k] = k <= 3 ? $(2 + k) : $(2 + k) * $12 / 68568.415; next }
  { e[$1, $2] = $3 }
  END { for (k = 1; k <= 9; ++k) { q = -(e[k, 1] - e[k, -1]) / 2e-4; off = q - known[k]; off = off < 0 ? -off : off
      size = q < 0 ? -q : q; largest = size > largest ? size : largest
      if (k <= 3 && off > force) force = off; if (k > 3 && off > stress) stress = off
      if (off > (k <= 3 ? 1e-8 : 2e-3)) { print k, q, known[k]; bad = 1 } }
    print "worst difference of a force", force, "and of a stress", stress, "of at most", largest; exit bad }' energies

# Spheres that come to touch, or cease to, change a force at once: the error falls with the step, not with its square.
for run in "4 320" "2 640" "1 1280"; do
  read -r dt steps <<<"$run"
  system 1 lj/cut "0.0914 3.95" ", virial=False" >nve
  cat >>nve <<EOF
pair_modify shift yes
timestep $dt
velocity all create 100 4711 loop geom
fix nve all nve
thermo $((steps / 40))
log kept.$dt
run $steps
EOF
  mpirun -n 2 lmp -in nve -screen none >nve.log 2>&1 || { cat nve.log && exit 1; }
  awk -v steps="$steps" '$1 == "Step" { on = 1; next } /^Loop/ { on = 0 }
    on && $1 == 0 { first = $2 } on { sum += ($2 - first)^2; ++n } END { printf "%.4f\n", sqrt(sum / n); exit n != 41 }' "kept.$dt"
done >kept
awk '{ rms[NR] = $1 } END { exit !(NR == 3 && rms[1] > rms[3] * 3 && rms[2] > rms[3] * 0.5 && rms[3] < 0.02) }' kept ||
  { echo "the total energy goes by" && cat kept && exit 1; }
echo "512 atoms, the same bits with 1, 2 and 4 ranks; energy goes by" $(cat kept)
