#!/usr/bin/env bash
# Tests that take packages which a plain machine lacks must have run, not been skipped: some wherever this is called, those
# of codes that the library is put into where these are installed.
#   have_run.sh LOG..    what ctest printed
set -euo pipefail
logs=("$@")
missing=0
must_have_run() {
  grep -qE "[: ]$1 \.+ +Passed" "${logs[@]}" && return
  echo "the test $1 did not run" >&2
  missing=1
}
for name in portability_mips packaging_library_variants_lld packaging_library_variants_musl \
  packaging_firmware_size_m4 packaging_documentation instruction_budgets; do
  must_have_run $name
done

imports() { # packages of Debian's Python, which the tests ask first
  local python=/usr/bin/python3 package
  [ -x $python ] || python=python3
  for package; do "$python" -c "import $package" 2>/dev/null || return; done
}
has() { # a program, or a header
  case $1 in
    *.h) printf '#include <%s>\n' "$1" | c++ -std=c++17 -fsyntax-only -x c++ - 2>/dev/null ;;
    *) command -v "$1" >/dev/null ;;
  esac
}
if has gfortran; then must_have_run clients_exact_sasa; fi
if has gappa; then must_have_run proofs_bounds; fi
if has lmp && has mpirun && imports numpy; then must_have_run clients_lammps_fix; fi
if has lmp && imports numpy; then must_have_run clients_lammps_window; fi
if has xtb && imports ase scipy; then must_have_run clients_normal_modes; fi
if has mpicc && [ -e /usr/include/lammps/library.h ]; then must_have_run clients_lammps; fi
if has openmm/reference/ReferencePlatform.h; then must_have_run clients_openmm; fi
if has rustc; then must_have_run bindings_lens_rust; fi
if imports sys; then must_have_run python_module_lists; must_have_run python_module_wheel; fi
if imports numpy; then must_have_run python_module_numpy; must_have_run python_module_page; fi
if imports numpy MDAnalysis; then must_have_run python_module_mdanalysis; fi
if imports numpy ase; then must_have_run python_module_ase; fi
exit $missing
