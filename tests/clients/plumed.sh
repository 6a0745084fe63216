#!/usr/bin/env bash
# capi/clients/plumed in PLUMED itself: it compiles with the headers of PLUMED, and the driver prints the areas and volumes
# that the program has.
#   plumed.sh SOURCE-FOLDER ARCHIVE WORK-FOLDER C++-COMPILER
# Exit status 77: the variable HSP_PLUMED does not name the folder of PLUMED's sources.
set -euo pipefail
source=$1 archive=$2 work=$3 cxx=$4
[ -e "${HSP_PLUMED:-}/src/core/Colvar.h" ] || { echo "skipped: HSP_PLUMED names no folder of PLUMED" && exit 77; }
rm -rf "$work"
mkdir -p "$work"
cd "$work"
"$cxx" -std=c++20 -O2 -fPIC -shared -I"$HSP_PLUMED/src" -I"$HSP_PLUMED/src/include" -I"$source/include" \
  "$source/capi/clients/plumed/HspSurface.cpp" -o HspSurface.so "$archive" -lm -Wl,--exclude-libs,ALL
driver=$HSP_PLUMED/src/lib/plumed
[ -x "$driver" ] || driver=$(command -v plumed) || { echo "compiled; there is no driver" && exit 0; }
cp "$source/bench/molecules/crambin.pdb" .
awk '/^(ATOM|HETATM)/ { row[++n] = "X " substr($0, 31, 8) " " substr($0, 39, 8) " " substr($0, 47, 8) }
  END { print n; print "41 0 0 3 19.5 0 -2 1.5 23"; for (k = 1; k <= n; ++k) print row[k] }' crambin.pdb >crambin.xyz
cat >plumed.dat <<'INPUT'
LOAD FILE=HspSurface.so
s: HSP_SURFACE ATOMS=1-327 PDB=crambin.pdb NOPBC GROUP1=1-40
m: HSP_SURFACE ATOMS=1-327 PDB=crambin.pdb SMOOTH NOPBC
p: HSP_SURFACE ATOMS=1-40 BLOCKING=41-327 PDB=crambin.pdb NOPBC
b: HSP_SURFACE ATOMS=1-327 PDB=crambin.pdb PERIODIC
PRINT ARG=s.area,s.volume,m.area,m.volume,s.area-1,p.area,b.area FILE=colvar FMT=%.8f
INPUT
"$driver" --no-mpi driver --plumed plumed.dat --ixyz crambin.xyz --length-units A >log 2>&1 || { tail -n 20 log && exit 1; }
awk '!/^#/ { ++rows; if ($2 != "29.71323016" || $3 != "8.35732155" || $4 != "23.19064883" || $5 != "4.66489727" ||
    $6 != $7 || !($8 > 0)) bad = 1 } END { exit bad || rows != 1 }' colvar || { cat colvar && exit 1; }
cat colvar
