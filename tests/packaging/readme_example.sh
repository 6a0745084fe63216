#!/usr/bin/env bash
# The examples of README.md in C and Fortran, as they stand there, compile without a warning, link and run: a program, and
# a function and a subroutine `surface`, which main programs call here with two balls whose figures are known.
#   readme_example.sh README.md INCLUDE-FOLDER ARCHIVE WORK-FOLDER C-COMPILER [FORTRAN-COMPILER MODULE-FOLDER FORTRAN-ARCHIVE]
set -euo pipefail
readme=$1 include=$2 archive=$3 work=$4 cc=$5
rm -rf "$work"
mkdir -p "$work"

mkdir "$work/blocks"
awk -v folder="$work/blocks" -f "$(dirname "$0")/page_blocks.awk" "$readme"
c_blocks=("$work"/blocks/*.c) fortran_blocks=("$work"/blocks/*.fortran)
cp "${c_blocks[0]}" "$work/example.c"
grep -q 'int main' "$work/example.c" || { echo "README.md has no C example with a main function" && exit 1; }
grep -q 'hsp_' "$work/example.c" || { echo "README.md's example does not use the library" && exit 1; }

# Unit balls at distance 1: each loses a cap of height 1/2. The gradient of the area is 2 pi along the axis.
{
  echo '#include <hardsphere_workspace.h>'
  cat "${c_blocks[1]}"
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
for name in example surface; do
  "$cc" -std=c99 -Wall -Wextra -Wpedantic -Wno-missing-prototypes -Wstrict-prototypes -Werror -I"$include" \
    -o "$work/$name" "$work/$name.c" "$archive" -lm
  "$work/$name"
  # Both are C++ as well.
  "$cc" -x c++ -std=c++20 -Wall -Wpedantic -Werror -I"$include" -fsyntax-only "$work/$name.c"
done

if [ $# -ge 8 ]; then
  fortran=$6 modules=$7 fortran_archive=$8
  {
    cat "${fortran_blocks[0]}"
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
  (cd "$work" && "$fortran" -std=f2018 -Wall -I"$modules" -o surface_fortran surface.f90 "$fortran_archive" "$archive" -lm)
  "$work/surface_fortran"
fi
