#!/usr/bin/env bash
# The archive's demands on a link, its offers to it, and that it has no state.
#   archive_symbols.sh ARCHIVE SOURCE-FOLDER [FUNCTIONS]
# It may ask for memory copies, sqrt and the compiler's own arithmetic only: no heap, no exceptions, no C++ run time. It
# must offer the header's functions and nothing else that a user's program could clash with: what its objects need of each
# other is C++ in the namespace hsp or of a handle's type, and hidden, so that no shared library exports it; an archive of
# one object has nothing of that. It must not hold anything that can be written to while the program runs: no variables,
# no initialisation at run time.
# HSP_UNOPTIMIZED, if it is not empty: clang with -O0 neither hides inline functions of the standard library nor marks its own
# constants as such; both are let pass.
set -euo pipefail
export LC_ALL=C
archive=$1 source=$2
here=$(cd "$(dirname "$0")" && pwd)
# A file with the functions of the headers, one a line, where these are not all of them.
functions=${3:-}
failed=0
visible='^$' constants='^$'
if [ -n "${HSP_UNOPTIMIZED:-}" ]; then visible='^DEFAULT .* std::[a-z_]+<' constants='[.]Lconstinit([.][0-9]+)?$'; fi

complain() { # message, lines
  echo "$1"
  echo "$2" | sed 's/^/  /'
  failed=1
}

# Number, value, size, type, binding, visibility, section, name: visibility, section and name of what is not local. Of
# PowerPC's functions it says in brackets where calls from near begin.
symbols=$(readelf -sW "$archive" | sed 's/ \[<[^]]*\]//' | awk '$5 ~ /^(GLOBAL|WEAK|UNIQUE)$/ {print $6, $7, $8}')
offered=$(echo "$symbols" | awk '$2 != "UND" && $3 !~ /^_Z/ {print $3}' | sort)
inner=$(echo "$symbols" | awk '$2 != "UND" && $3 ~ /^_Z/ {print $1, $3}' | sort -u)

allowed='^(memcpy|memmove|memset|sqrt'
# libgcc: integer and floating-point arithmetic that the machine lacks. Tables of MIPS and PowerPC begin at _gp_disp and
# at .TOC.
allowed+='|__u?(div|mod|mul|divmod)[dts]i[34]|__(ash|lsh|ash?l|ash?r|lshr)[dt]i3|__(clz|clrsb|ctz|popcount|ffs|parity|bswap)[dst]i2'
allowed+='|__(float|floatun|fix|fixuns)[a-z]+|__aeabi_[a-z0-9_]+|__aarch64_[a-z]+[1248]_[a-z_]+'
allowed+='|_GLOBAL_OFFSET_TABLE_|_gp_disp|\.TOC\.)$'
asked=$(echo "$symbols" | awk '$2 == "UND" {print $3}' | sort -u | comm -23 - <(printf '%s\n' "$offered" "${inner//HIDDEN /}" | sort -u))
refused=$(echo "$asked" | grep -vE "$allowed" | grep -v '^$' || true)
[ -z "$refused" ] || complain "the archive asks for symbols that are not allowed:" "$refused"

declared=$(if [ -n "$functions" ]; then cat "$functions"; else bash "$here/header_functions.sh" "$source"; fi)
if ! diff -u --label header --label archive <(echo "$declared") <(echo "$offered"); then
  complain "the archive does not define exactly the functions of the header" ""
fi
# Without optimization inline functions of the standard library stand there, too. Some names are too long for c++filt.
others=$(echo "$inner" | c++filt | grep -vE '^HIDDEN (_ZNK?3hsp|.*(hsp(_[a-z]+)?|std)::|operator new\(unsigned [a-z]+, void\*\)$)' |
  grep -vE "$visible|^\$" || true)
[ -z "$others" ] || complain "the archive has inner symbols that are not hidden, or not the library's own:" "$others"
objects=$(ar t "$archive" | wc -l)
if [ "$objects" -eq 1 ] && [ -n "$inner" ]; then complain "one object, and inner symbols:" "$inner"; fi
# Name, type, address, offset, size, size of an entry, flags. Tables of pointers are written to by the loader only,
# such as PowerPC's .toc.
written=$(readelf -SW "$archive" | sed -n 's/^ *\[ *[0-9]*\] *//p' |
  awk -v constants="$constants" '$7 ~ /W/ && $5 !~ /^0+$/ && $1 !~ /^\.(data\.rel\.ro|toc$)/ && $1 !~ constants {print $1, "of size 0x" $5}')
[ -z "$written" ] || complain "the archive has sections that are written to at run time:" "$written"
[ $failed -eq 0 ] && echo "asks for: $(echo $asked); offers $(echo "$offered" | wc -l) functions," \
  "hides $(echo "$inner" | grep -c .); $objects objects"
exit $failed
