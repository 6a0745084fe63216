// Four doubles on every target, in one register or in two: for three axes and a radius, or for four balls. And four
// 64-bit integers, converted from four doubles. Everything has internal linkage.
#pragma once

#include <type_traits>

#include "lanes/wide_pairs.hpp"
#include "lanes/words.hpp"

namespace hsp {
namespace {

using Four = std::conditional_t<register_lanes == 4, Wide<double, 4>, WidePairs<double, 2>>;
using FourDoubles = Four::Real;

inline LaneBits lanes_where(const decltype(FourDoubles{} > FourDoubles{}) & mask) {
  return static_cast<LaneBits>(Four::set_lanes(mask));
}

#if defined(__AVX2__)
// Four integers, converted from doubles below 2^31 in size, and sums and products of such.
struct LongIntegers {
  __m256i v;

  static LongIntegers from(const FourDoubles &a) { return {_mm256_cvtepi32_epi64(_mm256_cvttpd_epi32(__m256d(a)))}; }
  friend LongIntegers operator+(LongIntegers a, LongIntegers b) { return {_mm256_add_epi64(a.v, b.v)}; }
  friend LongIntegers operator-(LongIntegers a, LongIntegers b) { return {_mm256_sub_epi64(a.v, b.v)}; }
};
// The factors are below 2^31 in size.
inline LongIntegers product(LongIntegers a, LongIntegers b) {
  return {_mm256_mul_epi32(a.v, b.v)};
}
// Rounds to nearest, for integers below 2^62 in size. The doubles 2^84 + 2^63 plus the upper half, and 2^52 plus the
// lower half, are exact; their bits are put together from those of the integer. The first difference is exact, too, and
// the last sum is rounded once. left_out is exact: either the difference has no smaller exponent than 2^52 plus the
// lower half, or the sum is exact.
inline FourDoubles to_doubles(LongIntegers a, FourDoubles &left_out) {
  const __m256i low = _mm256_blend_epi32(_mm256_set1_epi64x(0x4330000000000000), a.v, 0x55);
  const __m256i high = _mm256_xor_si256(_mm256_srli_epi64(a.v, 32), _mm256_set1_epi64x(0x4530000080000000));
  const __m256d both = _mm256_castsi256_pd(_mm256_set1_epi64x(0x4530000080100000));
  const FourDoubles upper(_mm256_sub_pd(_mm256_castsi256_pd(high), both)), lower(_mm256_castsi256_pd(low));
  const FourDoubles sum = upper + lower;
  left_out = lower - (sum - upper);
  return sum;
}
#else
// Without an instruction for products of 64 bits in lanes, plain integers are faster.
struct LongIntegers {
  int64_t v[4];

  static LongIntegers from(const FourDoubles &a) {
    return {{static_cast<int64_t>(a.first[0]), static_cast<int64_t>(a.first[1]), static_cast<int64_t>(a.second[0]),
             static_cast<int64_t>(a.second[1])}};
  }
  friend LongIntegers operator+(const LongIntegers &a, const LongIntegers &b) {
    return {{a.v[0] + b.v[0], a.v[1] + b.v[1], a.v[2] + b.v[2], a.v[3] + b.v[3]}};
  }
  friend LongIntegers operator-(const LongIntegers &a, const LongIntegers &b) {
    return {{a.v[0] - b.v[0], a.v[1] - b.v[1], a.v[2] - b.v[2], a.v[3] - b.v[3]}};
  }
};
inline LongIntegers product(const LongIntegers &a, const LongIntegers &b) {
  return {{a.v[0] * b.v[0], a.v[1] * b.v[1], a.v[2] * b.v[2], a.v[3] * b.v[3]}};
}
inline FourDoubles to_doubles(const LongIntegers &a, FourDoubles &left_out) {
  double rounded[4], rest[4];
  for (int k = 0; k < 4; ++k) {
    rounded[k] = static_cast<double>(a.v[k]);
    rest[k] = static_cast<double>(a.v[k] - static_cast<int64_t>(rounded[k]));
  }
  left_out = Four::of(rest[0], rest[1], rest[2], rest[3]);
  return Four::of(rounded[0], rounded[1], rounded[2], rounded[3]);
}
#endif
inline FourDoubles to_doubles(const LongIntegers &a) {
  FourDoubles left_out{};
  return to_doubles(a, left_out);
}

}  // namespace
}  // namespace hsp
