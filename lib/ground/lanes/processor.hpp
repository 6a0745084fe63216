// Code for AVX2 beside that of the target's baseline, chosen when a handle is made: cpuid is asked there, so nothing is
// imported and nothing is global. HSP_AVX2 says that the library holds such code (lib/library.cmake).
//
// Files *_avx2.cpp hold it. They are compiled with -mavx2 -mfma -mpopcnt and must not emit any function that other
// files emit as well: the linker keeps one copy of an inline function, and this one would run on processors without
// AVX2. So they take raw pointers, include headers of plain structs and constants only, and keep what they define in an
// anonymous namespace. packaging_archive_variants looks at their symbols.
//
// What these files compute decides or discards with proven error bounds, hence fused operations are welcome there.
// Numbers that become results are computed without them, or rounded once from an exact value.
#pragma once

#if HSP_AVX2
#include <cpuid.h>
#endif

namespace hsp {

#if HSP_AVX2
inline bool has_avx2() {
  if (__get_cpuid_max(0, nullptr) < 7) return false;
  unsigned a = 0, b = 0, c = 0, d = 0;
  __cpuid_count(1, 0, a, b, c, d);
  // The instructions, and that the operating system saves the registers.
  constexpr unsigned needed = bit_FMA | bit_POPCNT | bit_OSXSAVE | bit_AVX;
  if ((c & needed) != needed) return false;
  unsigned low = 0, high = 0;
  __asm__("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
  if ((low & 6U) != 6U) return false;
  __cpuid_count(7, 0, a, b, c, d);
  return (b & bit_AVX2) != 0;
}
#else
constexpr bool has_avx2() {
  return false;
}
#endif

}  // namespace hsp
