// Eight floats at once on every target: one register of AVX2, else two of four. Everything has internal linkage.
#pragma once

#if defined(__AVX2__)
#include "lanes/avx2_lanes.hpp"
#endif

#include <cstdint>
#include <cstring>

namespace hsp {
namespace {

#if defined(__AVX2__)
using EightFloats = Floats;
#else
typedef float FourFloats __attribute__((vector_size(16)));
typedef int32_t FourMasks __attribute__((vector_size(16)));  // -1 where true

// The operations of Floats (lanes/avx2_lanes.hpp) for every processor, by two vectors.
struct EightFloats {
  FourFloats low, high;

  static EightFloats load(const float *p) {
    EightFloats a;
    std::memcpy(&a.low, p, sizeof a.low);
    std::memcpy(&a.high, p + 4, sizeof a.high);
    return a;
  }
  static EightFloats all(float x) { return {FourFloats{x, x, x, x}, FourFloats{x, x, x, x}}; }
  void store(float *p) const {
    std::memcpy(p, &low, sizeof low);
    std::memcpy(p + 4, &high, sizeof high);
  }

  friend EightFloats operator+(const EightFloats &a, const EightFloats &b) { return {a.low + b.low, a.high + b.high}; }
  friend EightFloats operator-(const EightFloats &a, const EightFloats &b) { return {a.low - b.low, a.high - b.high}; }
  friend EightFloats operator*(const EightFloats &a, const EightFloats &b) { return {a.low * b.low, a.high * b.high}; }
  friend EightFloats fused(const EightFloats &a, const EightFloats &b, const EightFloats &c) { return a * b + c; }
  friend uint32_t not_less(const EightFloats &a, const EightFloats &b) {
    const FourMasks bits =
        ((a.low >= b.low) & FourMasks{1, 2, 4, 8}) | ((a.high >= b.high) & FourMasks{16, 32, 64, 128});
    uint64_t halves[2];
    std::memcpy(halves, &bits, sizeof halves);
    const uint64_t both = halves[0] | halves[1];
    return static_cast<uint32_t>(both | both >> 32);
  }
};
#endif

}  // namespace
}  // namespace hsp
