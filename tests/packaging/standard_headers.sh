#!/usr/bin/env bash
# Which headers of the standard library the sources of the library include: none that brings heap, exceptions, streams or
# state. archive_symbols.sh looks at what the sources were compiled to. A loop over a list in braces includes its header
# itself: where several sources are one unit, another one may have done so.
#   standard_headers.sh SOURCE-FOLDER
set -euo pipefail
cd "$1"
allowed='bit|cfloat|cmath|compare|cstddef|cstdint|cstring|initializer_list|limits|new|type_traits|utility'

# The compiler's own, for code beyond the target's baseline (lib/ground/lanes/target.hpp).
allowed+='|arm_neon.h|cpuid.h|emmintrin.h|immintrin.h|smmintrin.h|tmmintrin.h|wasm_simd128.h'

includes=$(grep -nE '^[[:space:]]*#[[:space:]]*include[[:space:]]*<' -r lib capi/shims)
if refused=$(grep -vE "include[[:space:]]*<($allowed)>" <<<"$includes"); then
  echo "not among the headers that the library may include:"
  echo "$refused"
  exit 1
fi
mapfile -t loops < <(grep -rlE 'for \(.* : \{' lib capi/shims)
lacking=$(grep -L '<initializer_list>' "${loops[@]}" || true)
if [ -n "$lacking" ]; then
  echo "these do not include <initializer_list>:"
  echo "$lacking"
  exit 1
fi
echo "$(wc -l <<<"$includes") includes of the standard library"
