// The targets: instruction sets for which kernels are compiled, and which of them this processor runs. The processor is
// asked when a handle is made, by cpuid: nothing is imported and nothing is global. lib/library.cmake has the list of
// targets, with their compiler options; HSP_AVX2 says that avx2 is one of them, HSP_LANES that the registers of the
// baseline hold several numbers.
//
// Kernels are sources whose names have a second ending, kernel. They are compiled once for each target, into namespace
// hsp::HSP_TARGET. They must not emit any function that other files emit as well: the linker keeps one copy of an
// inline function, and a copy from a kernel would run on processors without its instructions. So kernels take raw
// pointers, and include only headers of plain structs, of constants and of code with internal linkage.
// packaging/target_symbols.sh checks their symbols.
//
// All decisions of kernels have proven error bounds, so that fused operations are welcome there. Numbers that become
// results are computed without these, or rounded once from an exact value.
#pragma once

#include <cstdint>

#if HSP_AVX2
#include <cpuid.h>
#define HSP_WITH_AVX2(...) __VA_ARGS__
#else
#define HSP_WITH_AVX2(...)
#endif

// Declares a kernel: in the namespace of each target a function with this result, name and parameters, and one that
// takes a Target before the parameters and calls the function of that target. `arguments` are the names of the
// parameters. Both lists are in parentheses.
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

// The whole library is compiled for the baseline.
enum class Target : uint8_t { baseline, avx2 };

// Whether there are kernels that use words.hpp. Where a register holds one number, these would be slower and larger
// than plain loops.
#if HSP_LANES
inline constexpr bool has_lanes = true;
#else
inline constexpr bool has_lanes = false;
#endif

// The widest target that both the library and this processor have.
#if HSP_AVX2
inline constexpr bool has_further_targets = true;
inline Target best_target() {
  unsigned a = 0, b = 0, c = 0, d = 0;
  __cpuid_count(1, 0, a, b, c, d);
  // The processor must have the instructions, and the operating system must save the registers. If it does, cpuid has
  // leaf 13, and so leaf 7, which is read below: the number of leaves need not be asked.
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
