#!/usr/bin/env bash
# The record of the binary interface in capi/abi against the headers: declarations and macros, values of constants,
# layouts of structs.
# The layouts are those of every target: clang, where it is there, compiles them as assertions for a list of targets.
#   abi.sh SOURCE-FOLDER WORK-FOLDER C-COMPILER [--write]
# --write makes the record anew. What that may change in a release: capi/abi/README.md.
set -euo pipefail
export LC_ALL=C
source=$(cd "$1" && pwd) work=$2 cc=$3 write=${4:-}
here=$(cd "$(dirname "$0")" && pwd)
header=$source/include/hardsphere.h
targets="x86_64-linux-gnu i386-linux-gnu x86_64-windows-msvc aarch64-linux-gnu arm64-apple-macos thumbv6m-none-eabi
  thumbv7em-none-eabihf armv7-linux-gnueabihf riscv32-none-elf riscv64-linux-gnu powerpc64le-linux-gnu s390x-linux-gnu
  mips-linux-gnu wasm32-wasi"
rm -rf "$work"
mkdir -p "$work"
abi=$(sed -nE "s|^#define HSP_ABI_NUMBER ([0-9]+).*|\1|p" "$source/include/hardsphere/version.h")

{
  echo "# Declarations of ABI number $abi"
  bash "$here/header_text.sh" "$header" | "$cc" -x c -std=c99 -D'HSP_API=@' -E -P - | tr '\n' ' ' | tr ';' '\n' |
    sed -nE 's/ +/ /g; s/^.*@ (.*)$/\1/p; s/^ ?(typedef [^{]*)$/\1/p' | sort
  # What macros with arguments say is compiled into programs.
  echo "#include \"$header\"" | "$cc" -x c -std=c99 -E -dM - | sed -nE 's/^#define (HSP_[A-Z0-9_]+\(.*)$/\1/p' | sort
} >"$work/functions.txt"

{
  echo "# Constants of ABI number $abi"
  {
    printf '#include "%s"\n#include <stdio.h>\nint main(void) {\n' "$header"
    # What changes with every release by itself is no part of it.
    while read -r name; do
      printf '  printf("%%s %%lld\\n", "%s", (long long)(%s));\n' "$name" "$name"
    done < <(bash "$here/header_constants.sh" "$header" "$cc" | grep -vE '_VERSION_|HSP_(ABI|NUMERICS)_NUMBER')
    printf '  return 0;\n}\n'
  } >"$work/constants.c"
  "$cc" -std=c99 -o "$work/constants" "$work/constants.c"
  "$work/constants"
} >"$work/constants.txt"

bash "$here/header_structs.sh" "$header" "$cc" >"$work/structs"
fields() { # calls `struct name` and `field name type field length` in turn
  while read -r name rest; do
    struct "$name"
    for part in $rest; do
      local field=${part#*:} length=1
      case $field in *'('*) length=${field#*(} length=${length%)} ;; esac
      field "$name" "${part%%:*}" "${field%(*}" "$length"
    done
  done <"$work/structs"
}
{
  echo "# Structs of ABI number $abi, for every target: size, then offset of each field, its type, and how many"
  {
    printf '#include "%s"\n#include <stdio.h>\nint main(void) {\n' "$header"
    struct() { printf '  printf("%%s %%d\\n", "%s", (int)sizeof(%s));\n' "$1" "$1"; }
    field() { printf '  printf("%%s.%%s %%d %%s %%s\\n", "%s", "%s", (int)offsetof(%s, %s), "%s", "%s");\n' "$1" "$3" "$1" "$3" "$2" "$4"; }
    fields
    printf '  return 0;\n}\n'
  } >"$work/structs.c"
  "$cc" -std=c99 -o "$work/layout" "$work/structs.c"
  "$work/layout"
} >"$work/structs.txt"

failed=0
for record in functions constants structs; do
  [ "$(wc -l <"$work/$record.txt")" -gt 20 ] || { echo "$record: nothing found in the headers" && exit 1; }
  if [ "$write" = --write ]; then
    cp "$work/$record.txt" "$source/capi/abi/$record.txt"
  elif ! diff -u --label "capi/abi/$record.txt" --label headers "$source/capi/abi/$record.txt" "$work/$record.txt"; then
    failed=1
  fi
done

# No padding but at no field either: records can be compared and hashed as bytes.
awk '/^#/ { next }
  NR == FNR { if (NF == 2) size_of[$1] = $2; next }
  NF == 2 { if (name != "" && end != size) { print name " ends with padding"; bad = 1 }
            name = $1; size = $2; end = 0; next }
  { width = $3 in size_of ? size_of[$3] : $3 ~ /32/ ? 4 : $3 ~ /64|double/ ? 8 : 0
    if (!width || $2 != end) { print $1 " has padding before it"; bad = 1 }
    end = $2 + width * $4 }
  END { if (end != size) { print name " ends with padding"; bad = 1 } exit bad }' "$work/structs.txt" "$work/structs.txt" || failed=1

compared=0
clang=$(command -v clang-14 || command -v clang || true)
if [ -n "$clang" ]; then
  {
    printf '#include "%s"\n#include <stddef.h>\n' "$header"
    awk '/^#/ { next }
      NF == 2 { print "_Static_assert(sizeof(" $1 ") == " $2 ", \"" $1 "\");"; next }
      { split($1, part, "."); place = "offsetof(" part[1] ", " part[2] ") == " $2
        print "_Static_assert(" place ", \"" $1 "\");" }' "$source/capi/abi/structs.txt"
  } >"$work/asserted.c"
  for target in $targets; do
    compared=$((compared + 1))
    "$clang" --target="$target" -std=c11 -ffreestanding -nostdlibinc -fsyntax-only "$work/asserted.c" 2>"$work/errors" || {
      echo "$target:"
      head -n 5 "$work/errors"
      failed=1
    }
  done
fi
[ $failed -eq 0 ] || { echo "see capi/abi/README.md" && exit 1; }
echo "$(($(wc -l <"$work/functions.txt") - 1)) declarations, $(($(wc -l <"$work/constants.txt") - 1)) constants," \
  "$(wc -l <"$work/structs") structs, $compared further targets"
