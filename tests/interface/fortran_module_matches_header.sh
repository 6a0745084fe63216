#!/usr/bin/env bash
# The Fortran module against the header: every function, every constant and its value, every struct and its fields, in
# both directions.
#   fortran_module_matches_header.sh HEADER MODULE.f90 C-COMPILER FORTRAN-COMPILER ARCHIVE WORK-FOLDER
set -euo pipefail
export LC_ALL=C
header=$1 module=$2 cc=$3 fc=$4 archive=$5 work=$6
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
bash "$(dirname "$0")/../packaging/header_functions.sh" "$header" >"$work/functions.header"
grep -oE 'bind\(C, name="[a-z0-9_]+"\)' "$module" | sed 's/.*"\(.*\)".*/\1/' | sort >"$work/functions.module"
same functions "$work/functions.header" "$work/functions.module"

# ---- constants: the compilers themselves say what each is worth, as a 32-bit number
echo "#include \"$header\"" >"$work/header.c"
"$cc" -std=c99 -E -dM "$work/header.c" | awk '$1 == "#define" && $2 ~ /^HSP_[A-Z0-9_]+$/ && NF > 2 {print $2}' |
  sort >"$work/constants"
sed -n 's/.*parameter :: \(HSP_[A-Z0-9_]*\) = .*/\1/p' "$module" | sort >"$work/constants.module"
same "names of constants" "$work/constants" "$work/constants.module"
{
  echo "#include \"$header\""
  echo '#include <stdio.h>'
  echo 'int main(void) {'
  while read -r name; do
    echo "  printf(\"$name %ld\\n\", (long)(int32_t)(uint32_t)(int64_t)($name));"
  done <"$work/constants"
  # the size macros, at arguments that tell their coefficients apart
  echo '  printf("model bytes %zu %zu\n", HSP_MODEL_BYTES(0), HSP_MODEL_BYTES(1000));'
  for limits in 0,0,0,0 1000,0,0,0 0,1000,0,0 0,0,1000,0 0,0,0,1000; do
    echo "  printf(\"boundary bytes %zu\n\", HSP_BOUNDARY_BYTES($limits));"
  done
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
  echo "  print '(a, i0, 1x, i0)', 'model bytes ', hsp_model_bytes_bound(0), hsp_model_bytes_bound(1000)"
  for limits in 0,0,0,0 1000,0,0,0 0,1000,0,0 0,0,1000,0 0,0,0,1000; do
    echo "  print '(a, i0)', 'boundary bytes ', hsp_boundary_bytes_bound($limits)"
  done
  echo 'end program'
} >"$work/constants.f90"
(cd "$work" && "$fc" -o constants.f90.out "$module" constants.f90 "$archive" -lm)
"$work/constants.f90.out" >"$work/values.module"
same "values of constants and size macros" "$work/values.header" "$work/values.module"

# ---- structs: names and fields in order, one line each. Offsets follow, since both sides are laid out as C.
"$cc" -std=c99 -fpreprocessed -dD -E -P "$header" 2>/dev/null | tr '\n' ' ' |
  grep -oE 'typedef struct hsp_[a-z_]+ \{[^}]*\}' |
  sed -E 's/typedef struct (hsp_[a-z_]+) \{/\1/; s/\}//; s/uint32_t/int32/g; s/int32_t/int32/g; s/int64_t/int64/g; s/[[:space:]]+/ /g' |
  awk '{n = split($0, part, ";"); split(part[1], first, " ");
        line = first[1];
        for (i = 1; i <= n; ++i) { m = split(part[i], word, " "); if (m < 2) continue;
          type = word[m - 1]; field = word[m]; size = ""; if (match(field, /\[[0-9]+\]/)) {
            size = substr(field, RSTART + 1, RLENGTH - 2); field = substr(field, 1, RSTART - 1) }
          line = line " " type ":" field (size == "" ? "" : "(" size ")") }
        print line}' | sort >"$work/structs.header"
awk '/^ *type, bind\(C\) ::/ {line = $NF; inside = 1; next}
     inside && /end type/ {print line; inside = 0}
     inside && /::/ {sub(/!.*/, ""); type = $0 ~ /real\(c_double\)/ ? "double" : $0 ~ /c_int64_t/ ? "int64" : "int32";
                     line = line " " type ":" $NF}' "$module" | sort >"$work/structs.module"
same structs "$work/structs.header" "$work/structs.module"
exit $failed
