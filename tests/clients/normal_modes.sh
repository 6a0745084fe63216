#!/usr/bin/env bash
# Normal modes of ethanol by xtb's own second derivatives in gas and those of a surface tension by `hardsphere hessian`:
# the same frequencies however the molecule is turned, where xtb's grid of a surface moves one by 15 cm-1.
#   normal_modes.sh PROGRAM WORK-FOLDER
# Exit status 77: xtb, ASE or SciPy is missing here; packages xtb, python3-ase, python3-scipy.
set -euo pipefail
program=$1 work=$2
here=$(cd "$(dirname "$0")" && pwd)
export LC_ALL=C OMP_NUM_THREADS=1 PYTHONDONTWRITEBYTECODE=1
python=/usr/bin/python3
command -v xtb >/dev/null || { echo "skipped: there is no xtb here" && exit 77; }
for package in ase scipy; do
  $python -c "import $package" 2>/dev/null || { echo "skipped: there is no $package here" && exit 77; }
done
rm -rf "$work"
mkdir -p "$work"
cd "$work"
cat >ethanol.xyz <<'EOF'
9

C   1.1879  -0.3829   0.0000
C   0.0000   0.5526   0.0000
O  -1.1867  -0.2472   0.0000
H  -1.9237   0.3850   0.0000
H   2.0985   0.2306   0.0000
H   1.1184  -1.0093   0.8869
H   1.1184  -1.0093  -0.8869
H  -0.0227   1.1812   0.8852
H  -0.0227   1.1812  -0.8852
EOF
xtb ethanol.xyz --gfn 2 --opt extreme >optimised 2>&1 || { tail optimised && exit 1; }
xtb xtbopt.xyz --gfn 2 --hess >derived 2>&1 || { tail derived && exit 1; }
$python "$here/normal_modes.py" "$program" xtbopt.xyz hessian
