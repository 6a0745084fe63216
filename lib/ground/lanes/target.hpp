// The instruction sets that kernels are compiled for, and which of them this processor runs. It is asked when a handle
// is made, by cpuid: nothing is imported and nothing is global. lib/library.cmake has the list, with their options;
// HSP_AVX2 says that it holds avx2, HSP_LANES that the registers of the baseline hold several numbers.
//
// Kernels are sources with a second ending, kernel; they are compiled once for each target, into namespace
// hsp::HSP_TARGET. They must not emit any function that other files emit as well: the linker keeps one copy of an
// inline function, and this one would run on processors without its instructions. So they take raw pointers, include
// headers of plain structs, constants and of what has internal linkage only. packaging/target_symbols.sh looks at
// their symbols.
//
// All that kernels decide or discard has proven error bounds, hence fused operations are welcome there. Numbers that
// become results are computed without them, or rounded once from an exact value.
#pragma once

#include <cstdint>

#if HSP_AVX2
#include <cpuid.h>
#define HSP_WITH_AVX2(...) __VA_ARGS__
#else
#define HSP_WITH_AVX2(...)
#endif

// Declares a kernel: in the namespace of each target a function of this result, name and parameters, and one that calls
// the target's, which it takes before the parameters; `arguments` are their names. Both lists are in parentheses.
#define HSP_KERNEL(result, name, parameters, arguments)                     \
  namespace baseline {                                                      \
  result name parameters;                                                   \
  }                                                                         \
  HSP_WITH_AVX2(namespace avx2 { result name parameters; })                 \
  inline result name([[maybe_unused]] Target target, HSP_LIST parameters) { \
    HSP_WITH_AVX2(if (target == Target::avx2) return avx2::name arguments;) \
    return baseline::name arguments;                                        \
  }
#define HSP_LIST(...) __VA_ARGS__

namespace hsp {

// The baseline is what the whole library is compiled for.
enum class Target : uint8_t { baseline, avx2 };

// Whether there are kernels of lanes, words.hpp: those that are slower than plain loops, and larger, where a register
// holds one number.
#if HSP_LANES
inline constexpr bool has_lanes = true;
#else
inline constexpr bool has_lanes = false;
#endif

// The widest that both the library and this processor have.
#if HSP_AVX2
inline constexpr bool has_further_targets = true;
inline Target best_target() {
  unsigned a = 0, b = 0, c = 0, d = 0;
  __cpuid_count(1, 0, a, b, c, d);
  // The instructions, and that the operating system saves the registers. Where it does, cpuid has leaf 13, and so
  // leaf 7 below: how many leaves there are need not be asked.
  constexpr unsigned needed = bit_FMA | bit_POPCNT | bit_OSXSAVE | bit_AVX;
  if ((c & needed) != needed) return Target::baseline;
  unsigned low = 0, high = 0;
  __asm__("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
  if ((low & 6U) != 6U) return Target::baseline;
  __cpuid_count(7, 0, a, b, c, d);
  return (b & bit_AVX2) != 0 ? Target::avx2 : Target::baseline;
}
#else
inline constexpr bool has_further_targets = false;
constexpr Target best_target() {
  return Target::baseline;
}
#endif

}  // namespace hsp
