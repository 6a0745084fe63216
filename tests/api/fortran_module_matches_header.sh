#!/usr/bin/env bash
# The Fortran module against the header: every function with its arguments, every constant and its value, every struct
# with its size and the offsets of its fields, in both directions.
#   fortran_module_matches_header.sh HEADER MODULE.f90 C-COMPILER FORTRAN-COMPILER ARCHIVE WORK-FOLDER
set -euo pipefail
export LC_ALL=C
header=$1 module=$2 cc=$3 fc=$4 archive=$5 work=$6
here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$work"
mkdir -p "$work"
failed=0

# Lists that must be equal: prints both sides of a difference.
same() {
  if [ ! -s "$2" ]; then
    echo "$1: nothing found in the header"
    failed=1
  elif ! diff -u --label header --label module "$2" "$3"; then
    echo "$1: the Fortran module and the header differ"
    failed=1
  else
    echo "$1: $(wc -l <"$2") agree"
  fi
}

# ---- functions
bash "$here/../packaging/header_functions.sh" "$header" >"$work/functions.header"
grep -oE 'bind\(C, name="[a-z0-9_]+"\)' "$module" | sed 's/.*"\(.*\)".*/\1/' | sort >"$work/functions.module"
same functions "$work/functions.header" "$work/functions.module"

# ---- their results and arguments: names, types, by value or by reference, and what is only read
# Text that is said to be preprocessed has no lines that go on in the next one.
bash "$here/../packaging/header_text.sh" "$header" | sed -e ':join' -e '/\\$/ { N; s/\\\n//; b join' -e '}' >"$work/headers.h"
"$cc" -std=c99 -fpreprocessed -dD -E -P "$work/headers.h" 2>/dev/null >"$work/bare_header"
sed '/^#/d' "$work/bare_header" | tr '\n' ' ' | tr -s ' ' | awk -f "$here/signatures_of_header.awk" |
  sort >"$work/signatures.header"
awk -f "$here/signatures_of_module.awk" "$module" | sort >"$work/signatures.module"
same signatures "$work/signatures.header" "$work/signatures.module"
cut -d' ' -f1 "$work/signatures.header" | diff -u --label header --label signatures "$work/functions.header" - || failed=1

# ---- constants: the compilers themselves say what each is worth, as a 32-bit number
bash "$here/../packaging/header_constants.sh" "$header" "$cc" >"$work/constants"
sed -n 's/.*integer(c_int32_t), parameter :: \(HSP_[A-Z0-9_]*\) = .*/\1/p' "$module" | sort >"$work/constants.module"
same "names of constants" "$work/constants" "$work/constants.module"
{
  echo "#include \"$header\""
  echo '#include <stdio.h>'
  echo 'int main(void) {'
  while read -r name; do
    echo "  printf(\"$name %ld\\n\", (long)(int32_t)(uint32_t)(int64_t)($name));"
  done <"$work/constants"
  echo '  printf("%s\n", HSP_VERSION_STRING);'
  # the size macros, at arguments that tell their coefficients apart
  echo '  printf("model bytes %zu %zu\n", HSP_MODEL_BYTES(0), HSP_MODEL_BYTES(1000));'
  echo '  printf("body bytes %zu %zu\n", HSP_BODY_BYTES(0), HSP_BODY_BYTES(1000));'
  for limits in 0,0,0,0 1000,0,0,0 0,1000,0,0 0,0,1000,0 0,0,0,1000; do
    echo "  printf(\"boundary bytes %zu\n\", HSP_BOUNDARY_BYTES($limits));"
    echo "  printf(\"worker bytes %zu\n\", HSP_WORKER_BYTES($limits));"
    echo "  printf(\"topology bytes %zu\n\", HSP_TOPOLOGY_BYTES($limits));"
    echo "  printf(\"view bytes %zu\n\", HSP_VIEW_BYTES(${limits%,*}));"
    echo "  printf(\"map bytes %zu\n\", HSP_MAP_BYTES(${limits%,*}));"
    echo "  printf(\"sticks bytes %zu\n\", HSP_STICKS_BYTES($limits));"
    echo "  printf(\"surface bytes %zu\n\", HSP_SURFACE_BYTES($limits,0,0));"
    echo "  printf(\"mesh bytes %zu\n\", HSP_MESH_BYTES($limits,0));"
    echo "  printf(\"contacts bytes %zu\n\", HSP_CONTACTS_BYTES($limits,0));"
  done
  echo '  printf("surface bytes %zu\n", HSP_SURFACE_BYTES(0,0,0,0,1000,0) + 2 * HSP_SURFACE_BYTES(0,0,0,0,0,1000));'
  echo '  printf("mesh bytes %zu\n", HSP_MESH_BYTES(0,0,0,0,1000));'
  echo '  printf("contacts bytes %zu\n", HSP_CONTACTS_BYTES(0,0,0,0,1000));'
  echo '  printf("periodic bytes %zu\n", HSP_PERIODIC_BYTES(1000,300,20,7,5,3));'
  echo '  printf("moving bytes %zu\n", HSP_MOVING_BYTES(1000,17));'
  # the algebra of quarter-edges, on the first two edges and at both ends of what fits
  for q in 0 1 2 3 4 5 6 7 1073741820 1073741823 2147483647; do
    echo "  printf(\"turned %ld %ld %ld\n\", (long)HSP_QUAD_ROT(UINT32_C($q)), (long)HSP_QUAD_INVERSE_ROT(UINT32_C($q)),"
    echo "         (long)HSP_QUAD_SYM(UINT32_C($q)));"
    echo "  printf(\"twin %ld %ld\n\", (long)HSP_SURFACE_TWIN(UINT32_C($q)), (long)HSP_MAP_TWIN(UINT32_C($q)));"
  done
  echo '  printf("turned %ld %ld %ld\n", (long)(int32_t)HSP_QUAD_ROT(HSP_NONE),'
  echo '         (long)(int32_t)HSP_QUAD_INVERSE_ROT(HSP_NONE), (long)(int32_t)HSP_QUAD_SYM(HSP_NONE));'
  echo '  printf("twin %ld %ld\n", (long)(int32_t)HSP_SURFACE_TWIN(HSP_NONE), (long)(int32_t)HSP_MAP_TWIN(HSP_NONE));'
  echo '  printf("half %ld\n", (long)HSP_STICKS_HALF(UINT32_C(1000), UINT32_C(10), UINT32_C(1)));'
  echo '  return 0; }'
} >"$work/constants.c"
"$cc" -std=c99 -o "$work/constants.c.out" "$work/constants.c"
"$work/constants.c.out" >"$work/values.header"
{
  echo 'program constants'
  echo '  use hardsphere'
  echo '  implicit none'
  while read -r name; do
    echo "  print '(a, 1x, i0)', '$name', $name"
  done <"$work/constants"
  echo "  print '(a)', HSP_VERSION_STRING"
  echo "  print '(a, i0, 1x, i0)', 'model bytes ', hsp_model_bytes_bound(0), hsp_model_bytes_bound(1000)"
  echo "  print '(a, i0, 1x, i0)', 'body bytes ', hsp_body_bytes_bound(0), hsp_body_bytes_bound(1000)"
  for limits in 0,0,0,0 1000,0,0,0 0,1000,0,0 0,0,1000,0 0,0,0,1000; do
    echo "  print '(a, i0)', 'boundary bytes ', hsp_boundary_bytes_bound($limits)"
    echo "  print '(a, i0)', 'worker bytes ', hsp_worker_bytes_bound($limits)"
    echo "  print '(a, i0)', 'topology bytes ', hsp_topology_bytes_bound($limits)"
    echo "  print '(a, i0)', 'view bytes ', hsp_view_bytes_bound(${limits%,*})"
    echo "  print '(a, i0)', 'map bytes ', hsp_map_bytes_bound(${limits%,*})"
    echo "  print '(a, i0)', 'sticks bytes ', hsp_sticks_bytes_bound($limits)"
    echo "  print '(a, i0)', 'surface bytes ', hsp_surface_bytes_bound($limits,0,0)"
    echo "  print '(a, i0)', 'mesh bytes ', hsp_mesh_bytes_bound($limits,0)"
    echo "  print '(a, i0)', 'contacts bytes ', hsp_contacts_bytes_bound($limits,0)"
  done
  echo "  print '(a, i0)', 'surface bytes ', hsp_surface_bytes_bound(0,0,0,0,1000,0) + 2 * hsp_surface_bytes_bound(0,0,0,0,0,1000)"
  echo "  print '(a, i0)', 'mesh bytes ', hsp_mesh_bytes_bound(0,0,0,0,1000)"
  echo "  print '(a, i0)', 'contacts bytes ', hsp_contacts_bytes_bound(0,0,0,0,1000)"
  echo "  print '(a, i0)', 'periodic bytes ', hsp_periodic_bytes_bound(1000,300,20,7,5,3)"
  echo "  print '(a, i0)', 'moving bytes ', hsp_moving_bytes_bound(1000,17)"
  for q in 0 1 2 3 4 5 6 7 1073741820 1073741823 2147483647 HSP_NONE; do
    echo "  print '(a, 2(i0, 1x), i0)', 'turned ', hsp_quad_rot($q), hsp_quad_inverse_rot($q), hsp_quad_sym($q)"
    echo "  print '(a, i0, 1x, i0)', 'twin ', hsp_surface_twin($q), hsp_map_twin($q)"
  done
  echo "  print '(a, i0)', 'half ', hsp_sticks_half(1000, 10, 1)"
  echo 'end program'
} >"$work/constants.f90"
(cd "$work" && "$fc" -o constants.f90.out "$module" constants.f90 "$archive" -lm)
"$work/constants.f90.out" >"$work/values.module"
same "values of constants and function-like macros" "$work/values.header" "$work/values.module"

# ---- structs: names and fields in order, one line each
bash "$here/../packaging/header_structs.sh" "$header" "$cc" | sed -E 's/ uint/ int/g; s/_t:/:/g' >"$work/structs.header"
awk '/^ *type, bind\(C\) ::/ {line = $NF; inside = 1; next}
     inside && /end type/ {print line; inside = 0}
     inside && /::/ {sub(/!.*/, ""); type = $0 ~ /real\(c_double\)/ ? "double" : $0 ~ /c_int64_t/ ? "int64" : "int32";
                     if (match($0, /type\(hsp_[a-z0-9_]+\)/)) type = substr($0, RSTART + 5, RLENGTH - 6)
                     line = line " " type ":" $NF}' "$module" | sort >"$work/structs.module"
same structs "$work/structs.header" "$work/structs.module"

# ---- and where the two compilers put each field
{
  echo "#include \"$header\""
  echo '#include <stdio.h>'
  echo 'int main(void) {'
  while read -r name fields; do
    echo "  printf(\"$name %zu\n\", sizeof($name));"
    for field in $fields; do
      field=${field#*:}
      field=${field%(*}
      echo "  printf(\"$name $field %zu %zu\n\", offsetof($name, $field), sizeof((($name *)0)->$field));"
    done
  done <"$work/structs.header"
  echo '  return 0; }'
} >"$work/layout.c"
"$cc" -std=c99 -o "$work/layout.c.out" "$work/layout.c"
"$work/layout.c.out" >"$work/layout.header"
{
  echo 'program layout'
  echo '  use, intrinsic :: iso_c_binding'
  echo '  use hardsphere'
  echo '  implicit none'
  while read -r name _; do echo "  type($name), target :: a_$name"; done <"$work/structs.header"
  while read -r name fields; do
    echo "  print '(a, i0)', '$name ', c_sizeof(a_$name)"
    for field in $fields; do
      field=${field#*:}
      field=${field%(*}
      echo "  print '(a, i0, 1x, i0)', '$name $field ', &"
      echo "    transfer(c_loc(a_$name%$field), 0_c_intptr_t) - transfer(c_loc(a_$name), 0_c_intptr_t), &"
      echo "    c_sizeof(a_$name%$field)"
    done
  done <"$work/structs.header"
  echo 'end program'
} >"$work/layout.f90"
(cd "$work" && "$fc" -o layout.f90.out "$module" layout.f90 "$archive" -lm)
"$work/layout.f90.out" >"$work/layout.module"
same "sizes of structs and places of fields" "$work/layout.header" "$work/layout.module"
exit $failed
