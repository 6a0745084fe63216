#!/usr/bin/env bash
# What the archive asks of a link, what it offers to it, and that it has no state.
#   archive_symbols.sh ARCHIVE SOURCE-FOLDER
# It may ask for memory copies, sqrt and the compiler's own arithmetic only: no heap, no exceptions, no C++ run time. It
# must offer the header's functions and nothing else that a user's program could clash with. It must not hold anything that
# can be written to while the program runs: no variables, no initialisation at run time.
set -euo pipefail
export LC_ALL=C
archive=$1 source=$2
here=$(cd "$(dirname "$0")" && pwd)
failed=0

# Number, value, size, type, binding, visibility, section, name: the last four columns matter.
symbols=$(readelf -sW "$archive" | awk '$5 ~ /^(GLOBAL|WEAK|UNIQUE)$/ {print $7, $8}')

allowed='^(memcpy|memmove|memset|sqrt'
# libgcc: integer and floating-point arithmetic that the machine lacks.
allowed+='|__u?(div|mod|mul|divmod)[dts]i[34]|__(ash|lsh|ash?l|ash?r|lshr)[dt]i3|__(clz|ctz|popcount|ffs|parity|bswap)[dst]i2'
allowed+='|__(float|floatun|fix|fixuns)[a-z]+|__aeabi_[a-z0-9_]+|_GLOBAL_OFFSET_TABLE_)$'
asked=$(echo "$symbols" | awk '$1 == "UND" {print $2}' | sort -u)
refused=$(echo "$asked" | grep -vE "$allowed" | grep -v '^$' || true)
if [ -n "$refused" ]; then
  echo "the archive asks for symbols that are not allowed:"
  echo "$refused" | sed 's/^/  /'
  failed=1
fi

offered=$(echo "$symbols" | awk '$1 != "UND" {print $2}' | sort)
if ! diff -u --label header --label archive <(bash "$here/header_functions.sh" "$source") <(echo "$offered"); then
  echo "the archive does not define exactly the functions of the header"
  failed=1
fi
# Name, type, address, offset, size, size of an entry, flags. Tables of pointers are written to by the loader only.
written=$(readelf -SW "$archive" | sed -n 's/^ *\[ *[0-9]*\] *//p' |
  awk '$7 ~ /W/ && $5 !~ /^0+$/ && $1 !~ /^\.data\.rel\.ro/ {print $1, "of size 0x" $5}')
if [ -n "$written" ]; then
  echo "the archive has sections that are written to at run time:"
  echo "$written" | sed 's/^/  /'
  failed=1
fi
[ $failed -eq 0 ] && echo "asks for: $(echo $asked); offers $(echo "$offered" | wc -l) functions"
exit $failed
