#!/usr/bin/env bash
# Trajectories that mdtraj, MDAnalysis and scipy write and read: the program measures of every frame what it measures of
# the frame's coordinates and box as these read them.
#   trajectory_oracles.sh PROGRAM SOURCE-FOLDER WORK-FOLDER
# Skipped where none is installed (Debian's python3-mdtraj, python3-mdanalysis, python3-scipy). PYTHON: another interpreter.
set -euo pipefail
program=$1 source=$2 work=$3
rm -rf "$work"
mkdir -p "$work"
# Debian's packages are for Debian's interpreter, which need not be the first one.
for python in ${PYTHON:-python3 /usr/bin/python3}; do
  status=77
  if command -v "$python" >/dev/null; then
    status=0
    "$python" "$source/tests/program/trajectory_oracles.py" "$program" "$source" "$work" || status=$?
  fi
  if [ "$status" -ne 77 ]; then exit "$status"; fi
done
echo "skipped: neither mdtraj, MDAnalysis nor scipy is installed"
exit 77
