#!/usr/bin/env bash
# Words that the library's sources do without: heap, exceptions, run-time type information, streams, global state.
# Comments and strings do not count.
#   words_kept_out.sh SOURCE-FOLDER C++-COMPILER
set -euo pipefail
cd "$1"
cxx=$2
words='malloc|calloc|realloc|alloca|aligned_alloc|free[[:space:]]*\(|delete[[:space:]]*(\[\]|[a-z_(])|new[[:space:]]+[A-Za-z_:<]'
words+='|throw|try|catch|typeid|dynamic_cast|thread_local|setlocale|getenv|errno|abort|exit|longjmp'
words+='|std::(vector|string|string_view|function|map|set|unordered_map|unordered_set|list|deque|unique_ptr|shared_ptr'
words+='|sort|stable_sort|stable_partition|inplace_merge|cout|cerr|ostream|mutex|thread|atomic|optional|array|span'
words+='|atan2?|a?sin|a?cos|tan|exp|log|pow|cbrt|hypot|fma|floor|round|llround|fmod)'
headers='iostream|ostream|istream|sstream|fstream|string|vector|map|set|functional|memory|algorithm|exception|stdexcept'
headers+='|mutex|thread|atomic|typeinfo|locale|cstdio|stdio\.h|cstdlib|stdlib\.h|cerrno|clocale'
failed=0
files=0
for file in $(find lib -name '*.hpp' -o -name '*.cpp' | sort) capi/*.cpp capi/*.hpp; do
  [ -e "$file" ] || continue
  files=$((files + 1))
  # The preprocessor takes comments away and, told that its work is done already, leaves the rest as it is.
  code=$("$cxx" -fpreprocessed -dD -E -w -x c++ "$file" 2>/dev/null | sed 's/"[^"]*"/""/g')
  if [ -z "$code" ]; then
    echo "$file: nothing left without comments"
    failed=1
  fi
  if found=$(grep -nE "(^|[^A-Za-z0-9_:])($words)([^A-Za-z0-9_]|$)" <<<"$code"); then
    echo "$file:"
    echo "$found"
    failed=1
  fi
  if found=$(grep -nE "#[[:space:]]*include[[:space:]]*<($headers)>" "$file"); then
    echo "$file:"
    echo "$found"
    failed=1
  fi
done
if [ $files -eq 0 ]; then
  echo "no file found"
  failed=1
fi
[ $failed -eq 0 ] && echo "$files files without heap, exceptions, streams and state"
exit $failed
