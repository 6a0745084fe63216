#!/usr/bin/env bash
# Kernels of one target define no symbol that others define as well, or the rest of the library: of an inline function
# that several objects define the linker keeps one, which would run on processors without the target's instructions. The
# baseline is what the whole library is compiled for, so its kernels may. Tables of constants are the same for all.
#   target_symbols.sh FOLDER-OF-OBJECTS
set -euo pipefail
export LC_ALL=C
cd "$1"

# The target of an object, as lib/library.cmake names its units: at the end, if it is not the baseline.
target_of() {
  case $1 in *_avx2.cpp.o*) echo avx2 ;; *) echo baseline ;; esac
}
defined=$(
  while read -r object; do
    target=$(target_of "$object")
    echo "= $target"
    nm -C --defined-only --extern-only "$object" | sed -nE "s/^[0-9a-f]+ [^RVuDBG] (.*)/$target \1/p"
  done < <(find . -name '*.o' -o -name '*.obj')
)
targets=$(sed -n 's/^= //p' <<<"$defined" | sort | uniq -c | awk '{print $2 " " $1}')
grep -q '^baseline ' <<<"$targets" || { echo "no objects in $1" && exit 1; }
if objdump -f "$(find . -name '*.o' | head -n 1)" | grep -q x86-64; then
  grep -q '^avx2 ' <<<"$targets" || { echo "no object is for AVX2" && exit 1; }
fi
shared=$(grep -v '^= ' <<<"$defined" | sort -u | awk '
  { name = substr($0, length($1) + 2); of[name] = of[name] " " $1; if (++count[name] == 2) shared[name] }
  END { for (name in shared) print name ":" of[name] }')
[ -z "$shared" ] || { echo "defined for more than one target:" && sed 's/^/  /' <<<"$shared" && exit 1; }
echo "no symbol is shared between objects for" $targets
