#!/usr/bin/env bash
# Each public header compiles on its own, as C99 and as C++20, hardsphere.hpp as C++20; hardsphere.h includes all that are in its folder and says
# what each is; every function that returns a status lists what it may return (@retval) and refers to no other for it.
#   headers.sh SOURCE-FOLDER C-COMPILER C++-COMPILER
set -euo pipefail
include=$1/include cc=$2 cxx=$3
failed=0
complain() {
  echo "$1"
  failed=1
}

headers=0
for header in "$include"/hardsphere.h "$include"/hardsphere_workspace.h "$include"/hardsphere/*.h; do
  headers=$((headers + 1))
  name=${header#"$include"/}
  # An object of its own, so that no translation unit is empty, and the header twice, so that its guard is tried.
  text=$(printf '#include <%s>\n#include <%s>\nint nothing;\n' "$name" "$name")
  "$cc" -std=c99 -Wall -Wextra -Wconversion -Wshadow -Wpedantic -Werror -I "$include" -x c -fsyntax-only - <<<"$text" ||
    complain "$name is no C99 on its own"
  "$cxx" -std=c++20 -Wall -Wextra -Wconversion -Wshadow -Wpedantic -Werror -I "$include" -x c++ -fsyntax-only - <<<"$text" ||
    complain "$name is no C++20 on its own"
  case $name in hardsphere/export.h | hardsphere/components.h | hardsphere_workspace.h | hardsphere.h) continue ;; esac
  grep -qF "#include \"$name\"" "$include/hardsphere.h" || complain "hardsphere.h does not include $name"
  grep -qF " *   $name " "$include/hardsphere.h" || complain "hardsphere.h does not say what $name is"
done
[ $headers -gt 5 ] || complain "the headers were not found"

"$cxx" -std=c++20 -Wall -Wextra -Wconversion -Wshadow -Wpedantic -Werror -I "$include" -x c++ -fsyntax-only - \
  <<<"$(printf '#include <hardsphere.hpp>\n#include <hardsphere.hpp>\n')" || complain "hardsphere.hpp is no C++20 on its own"
for older in 11 14 17; do
  refused=$("$cxx" -std=c++$older -I "$include" -x c++ -fsyntax-only - <<<'#include <hardsphere.hpp>' 2>&1) &&
    complain "hardsphere.hpp is C++$older"
  [ "$(grep -c ' error: ' <<<"$refused")" -eq 1 ] && grep -q 'error:.*-std=c++20' <<<"$refused" ||
    complain "hardsphere.hpp does not say in one error that it needs C++20: C++$older"
done

# Every declaration has the two marks of export.h, every callback the second one.
unmarked=$(grep -hE '^[a-z].* \*?hsp_[a-z_]+\(|\(\*[a-z_]+\)\(|^HSP_API' "$include"/hardsphere/*.h |
  grep -vE '^HSP_API (const char \*|u?int32_t )HSP_CALL hsp_|^typedef [a-z0-9_]+ HSP_CALL hsp_|\(HSP_CALL \*' || true)
[ -z "$unmarked" ] || complain "without HSP_API or HSP_CALL: $unmarked"

# A function's comment is the last one that ends before it. Awk reads whole comments and whole declarations.
functions=$(cat "$include"/hardsphere/*.h | awk '
  /^\/\*\*/ { comment = ""; inside = 1 }
  inside { comment = comment "\n" $0; if (/\*\//) inside = 0; next }
  /^HSP_API int32_t / {
    name = $4; sub(/\(.*/, "", name)
    print name
    if (comment !~ /@retval HSP_/) print "lists no status: " name
    if (comment ~ /[Ss]tatuses as|HSP_E_[A-Z_]+(, HSP_E_[A-Z_]+)* as /) print "refers to another: " name
    listed = comment
    while (match(listed, /@retval [A-Z_]+/)) {
      status = substr(listed, RSTART + 8, RLENGTH - 8); listed = substr(listed, RSTART + RLENGTH)
      if (seen[name, status]++) print "lists " status " twice: " name
    }
  }
  # A struct says its size or that it is frozen.
  /^typedef struct hsp_[a-z_]+ \{/ { name = $3; frozen = comment ~ /[Ff]rozen/; inside_struct = 1; next }
  inside_struct { if ((/struct_size;/) == frozen) print (frozen ? "frozen with struct_size: " : "neither frozen nor sized: ") name
                  inside_struct = 0 }
  /;/ { comment = "" }')
[ "$(grep -c '^hsp_' <<<"$functions")" -gt 40 ] || complain "the functions were not found"
grep -v '^hsp_' <<<"$functions" && failed=1
[ $failed -eq 0 ] && echo "$headers headers, $(grep -c '^hsp_' <<<"$functions") functions with a status"
exit $failed
