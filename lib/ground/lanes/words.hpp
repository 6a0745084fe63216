// Words for kernels that are written once and compiled for registers of several widths: Floats, Doubles, Integers and
// Fractions, as many of each as a register of the target holds, and their signs and comparisons as bits. They are in
// words_32.hpp for registers of 32 bytes and in words_16.hpp for 16 bytes; a target without registers of several lanes
// has none. Everything has internal linkage, so that kernels have their own copy for each target (target.hpp).
//
// fused(), fused_minus() and minus_fused() round once or twice, as the target has it. They are for decisions with error
// bounds that allow both, never for results.
#pragma once

#include <cstdint>

namespace hsp {
namespace {

// A bit for each lane, lane 0 lowest.
using LaneBits = uint32_t;

inline uint32_t lowest(LaneBits bits) {
  return static_cast<uint32_t>(__builtin_ctz(bits));
}

// Counts in each lane how often a comparison holds.
template <class Lanes>
struct LaneCounts;

}  // namespace
}  // namespace hsp

#if defined(__AVX2__)
#include "lanes/words_32.hpp"
#else
#include "lanes/words_16.hpp"
#endif

namespace hsp {
namespace {

// The number of set bits, for the lanes of one Floats.
#if defined(__POPCNT__) || defined(__wasm_simd128__)
inline uint32_t ones(LaneBits bits) {
  return static_cast<uint32_t>(__builtin_popcount(bits));
}
#else
constexpr uint8_t ones_of_four[16] = {0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4};
inline uint32_t ones(LaneBits bits) {
  static_assert(Floats::lanes == 4);
  return ones_of_four[bits];
}
#endif
// The bits of the lowest `count` lanes of one Floats; of all lanes if `count` is larger.
inline LaneBits first_lanes(uint32_t count) {
  const uint32_t chosen = count < Floats::lanes ? count : Floats::lanes;  // in one expression GCC makes branches of it
  return (1U << chosen) - 1U;
}

}  // namespace
}  // namespace hsp
