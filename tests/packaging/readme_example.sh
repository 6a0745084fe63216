#!/usr/bin/env bash
# The functions that README.md and languages.md of the guide show compile without a warning and give what main programs
# here expect: in C `water`, without any allocation, and `surface` with a workspace; in Fortran `surface`. The program in
# Fortran of tasks.md prints a line of the one in C.
#   readme_example.sh SOURCE-FOLDER ARCHIVE WORK-FOLDER C-COMPILER [FORTRAN-COMPILER MODULE-FOLDER FORTRAN-ARCHIVE]
set -euo pipefail
source=$1 archive=$2 work=$3 cc=$4
rm -rf "$work"
for page in README.md capi/guide/languages.md capi/guide/tasks.md; do
  folder=$work/$(basename "$page" .md)
  mkdir -p "$folder"
  awk -v folder="$folder" -f "$source/tests/packaging/page_blocks.awk" "$source/$page"
done
block() { # function, blocks: the one that has it
  local name=$1 found
  shift
  found=$(grep -lE "(int32_t|subroutine) $name\(" "$@") || { echo "no page shows $name" && exit 1; }
  cat "$found"
}

# Three unit balls that are apart, seen by a probe of 1.4.
{
  block water "$work"/README/*.c
  cat <<'MAIN'
#include <math.h>
int main(void) {
  const double pi = acos(-1.0), xyz[9] = {0, 0, 0, 6, 0, 0, 12, 0, 0}, radius[3] = {1, 1, 1};
  hsp_totals totals;
  if (water(xyz, radius, &totals) != HSP_OK) return 1;
  return fabs(totals.area / (12 * pi * 2.4 * 2.4) - 1) < 1e-14 && fabs(totals.volume / (4 * pi * 2.4 * 2.4 * 2.4) - 1) < 1e-14 ? 0 : 2;
}
MAIN
} >"$work/water.c"
# Unit balls at distance 1: each loses a cap of height 1/2. The gradient of the area is 2 pi along the axis.
{
  block surface "$work"/languages/*.c
  cat <<'MAIN'
#include <math.h>
int main(void) {
  const double pi = acos(-1.0), xyz[6] = {0, 0, 0, 1, 0, 0}, radius[2] = {1, 1};
  double area[2], gradient[6];
  hsp_totals totals;
  if (surface(2, xyz, radius, &totals, area, gradient) != HSP_OK) return 1;
  return fabs(totals.area - 6 * pi) < 1e-12 && fabs(area[0] - 3 * pi) < 1e-12 && fabs(gradient[3] - 2 * pi) < 1e-12 ? 0 : 2;
}
MAIN
} >"$work/surface.c"
for name in water surface; do
  "$cc" -std=c99 -Wall -Wextra -Wpedantic -Wno-missing-prototypes -Wstrict-prototypes -Werror -I"$source/include" \
    -o "$work/$name" "$work/$name.c" "$archive" -lm
  "$work/$name"
  # Both are C++ as well.
  "$cc" -x c++ -std=c++20 -Wall -Wpedantic -Werror -I"$source/include" -fsyntax-only "$work/$name.c"
done

if [ $# -ge 7 ]; then
  fortran=$5 modules=$6 fortran_archive=$7
  {
    block surface "$work"/languages/*.fortran
    cat <<'MAIN'
program check
  use hardsphere_workspace
  implicit none
  real(c_double), parameter :: pi = acos(-1.0_c_double)
  real(c_double) :: xyz(3, 2), area(2), gradient(3, 2)
  type(hsp_totals) :: totals
  integer(c_int32_t) :: status
  external :: surface
  xyz = 0
  xyz(1, 2) = 1
  call surface(2_c_int32_t, xyz, [1.0_c_double, 1.0_c_double], totals, area, gradient, status)
  if (status /= HSP_OK .or. abs(totals%area - 6*pi) > 1e-12 .or. abs(area(1) - 3*pi) > 1e-12 .or. &
      abs(gradient(1, 2) - 2*pi) > 1e-12) stop 1
end program
MAIN
  } >"$work/surface.f90"
  # As the page has it, and with its own program.
  cat "$work"/languages/*.fortran >"$work/page.f90"
  cp "$work"/tasks/*.fortran "$work/tasks.f90"
  for name in surface page tasks; do
    (cd "$work" && "$fortran" -std=f2018 -Wall -I"$modules" -o "$name"_fortran $name.f90 "$fortran_archive" "$archive" -lm)
  done
  "$work/surface_fortran"
  cmp <("$work/page_fortran") "$work"/languages/*.text
  "$work/tasks_fortran" | sed -n 1p | cmp - <(grep '^in a box' "$work"/tasks/*.text)
fi
