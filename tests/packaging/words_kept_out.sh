#!/usr/bin/env bash
# Words that the library's sources do without: heap, exceptions, run-time type information, streams, global state.
# Comments and strings do not count.
#   words_kept_out.sh SOURCE-FOLDER
set -euo pipefail
cd "$1"
# `new (` places an object into memory that is there; `= delete` and a variable called free are no words of the heap.
shapes='free[[:space:]]*\(|delete[[:space:]]*(\[\]|[A-Za-z_(*])|new[[:space:]]+[A-Za-z_:<]'
words='malloc|calloc|realloc|alloca|aligned_alloc'
words+='|throw|try|catch|typeid|dynamic_cast|thread_local|setlocale|getenv|errno|abort|exit|longjmp'
words+='|std::(vector|string|string_view|function|map|set|unordered_map|unordered_set|list|deque|unique_ptr|shared_ptr'
words+='|sort|stable_sort|stable_partition|inplace_merge|cout|cerr|ostream|mutex|thread|atomic|optional|array|span'
words+='|atan2?|a?sin|a?cos|tan|exp|log|pow|cbrt|hypot|fma|floor|round|llround|fmod)'
headers='iostream|ostream|istream|sstream|fstream|string|vector|map|set|functional|memory|algorithm|exception|stdexcept'
headers+='|mutex|thread|atomic|typeinfo|locale|cstdio|stdio\.h|cstdlib|stdlib\.h|cerrno|clocale'

# The file without comments and without what stands in quotes, line by line.
without_comments() {
  sed -e 's/\\.//g' -e 's/"[^"]*"/""/g' -e "s/'[^']*'/''/g" "$1" | awk '
    {
      line = ""
      rest = $0
      while (rest != "") {
        if (inside) {
          end = index(rest, "*/")
          if (end == 0) break
          rest = substr(rest, end + 2)
          inside = 0
          continue
        }
        block = index(rest, "/*")
        one_line = index(rest, "//")
        if (one_line > 0 && (block == 0 || one_line < block)) {
          line = line substr(rest, 1, one_line - 1)
          break
        }
        if (block == 0) {
          line = line rest
          break
        }
        line = line substr(rest, 1, block - 1) " "
        rest = substr(rest, block + 2)
        inside = 1
      }
      print line
    }'
}

failed=0
files=0
for file in $(find lib -name '*.hpp' -o -name '*.cpp' | sort) capi/*.cpp capi/*.hpp; do
  [ -e "$file" ] || continue
  files=$((files + 1))
  code=$(without_comments "$file")
  if [ -z "$code" ]; then
    echo "$file: nothing left without comments"
    failed=1
  fi
  if found=$(grep -nE "(^|[^A-Za-z0-9_:])(($words)([^A-Za-z0-9_]|$)|$shapes)" <<<"$code"); then
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
