// Words for kernels that are written once and compiled for registers of several widths: Floats, Doubles, Integers and
// Fractions, as many of each as a register of the target holds, and their signs and comparisons as bits. This file has
// all that both widths have by the same operations; the rest is in words_32.hpp for registers of 32 bytes and in
// words_16.hpp for 16 bytes; a target without registers of several lanes has none. Everything has internal linkage, so
// that kernels have their own copy for each target (target.hpp).
//
// fused(), fused_minus() and minus_fused() round once or twice, as the target has it. They are for decisions with error
// bounds that allow both, never for results.
//
// As an example four floats, lanes 0 to 3, and the results of some operations:
//   a                           5   1   7   3
//   b                           4   4   4   4
//   a - b                       1  -3   3  -1
//   larger(a, b)                5   4   7   4
//   fused_minus(a, b, b)       16   0  24   8     a b - b
//   greater(a, b)               1   0   1   0     as LaneBits 5, lane 0 being the lowest bit; ones(5) = 2
#pragma once

#include <cstdint>

#if defined(__SSE4_1__)
#include <smmintrin.h>
#elif defined(__SSSE3__)
#include <tmmintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
#elif defined(__wasm_simd128__)
#include <wasm_simd128.h>
#endif

#include "lanes/wide.hpp"

namespace hsp {
namespace {

// A bit for each lane, lane 0 lowest.
using LaneBits = uint32_t;

inline uint32_t lowest(LaneBits bits) {
  return static_cast<uint32_t>(__builtin_ctz(bits));
}

// Real numbers, as many as a register holds: Floats and Doubles.
template <class T>
struct Numbers {
  using Real = T;
  static constexpr uint32_t lanes = (register_lanes == 4 ? 32 : 16) / sizeof(T);
  using Word = Wide<T, lanes>;
  typename Word::Real v;

  static Numbers load(const T *p) { return {Word::load(p)}; }
  static Numbers all(T x) { return {Word::all(x)}; }
  static Numbers all_of(const T *p) { return {Word::all_of(p)}; }
  static Numbers ascending() { return {Word::ascending()}; }
  void store(T *p) const { Word::store(p, v); }

  friend Numbers operator+(Numbers a, Numbers b) { return {a.v + b.v}; }
  friend Numbers operator-(Numbers a, Numbers b) { return {a.v - b.v}; }
  friend Numbers operator*(Numbers a, Numbers b) { return {a.v * b.v}; }
  friend Numbers operator/(Numbers a, Numbers b) { return {a.v / b.v}; }
  friend Numbers operator-(Numbers a) { return {Word::negated(a.v)}; }

  // Comparisons; all false for NaN.
  friend LaneBits greater(Numbers a, Numbers b) { return set_lanes(a.v > b.v); }
  friend LaneBits not_less(Numbers a, Numbers b) { return set_lanes(a.v >= b.v); }

  // The lanes in which a mask is set.
  static LaneBits set_lanes(const typename Word::Mask &mask) {
#if defined(__aarch64__)
    if constexpr (lanes == 4) {
      constexpr uint32_t bit[4] = {1, 2, 4, 8};
      return vaddvq_u32(vandq_u32(uint32x4_t(mask), vld1q_u32(bit)));
    }
#elif defined(__wasm_simd128__)
    if constexpr (lanes == 4) return wasm_i32x4_bitmask(v128_t(mask));
#endif
    return static_cast<LaneBits>(Word::set_lanes(mask));
  }
};
using Floats = Numbers<float>;
using Doubles = Numbers<double>;
inline double first(Doubles a) {
  return a.v[0];
}

struct Integers {
  static constexpr uint32_t lanes = Floats::lanes;
  using Bits = Floats::Word::Bits;
  using Signed = Floats::Word::Mask;
  Bits v;

  static Integers of(const Signed &a) { return {reinterpret_cast<Bits>(a)}; }
  static Integers bits_of(Floats a) { return {reinterpret_cast<Bits>(a.v)}; }
  static Integers load(const uint32_t *p) { return bits_of(Floats::load(reinterpret_cast<const float *>(p))); }
  static Integers all(uint32_t x) { return {Bits{} + x}; }
  static Integers ascending() { return {__builtin_convertvector(Floats::Word::ascending(), Bits)}; }
  void store(uint32_t *p) const { Floats{reinterpret_cast<Floats::Word::Real>(v)}.store(reinterpret_cast<float *>(p)); }
  Signed with_sign() const { return reinterpret_cast<Signed>(v); }

  // All bits set in the lowest `count` lanes, none in the others.
  static Integers first_set(uint32_t count) { return of(all(count).with_sign() > ascending().with_sign()); }
  // All bits set in the lanes from `count` on, none in the others.
  static Integers all_set_from(uint32_t count) { return of(ascending().with_sign() > all(count - 1).with_sign()); }

  friend Integers operator+(Integers a, Integers b) { return {a.v + b.v}; }
  friend Integers operator-(Integers a, Integers b) { return {a.v - b.v}; }
  friend Integers operator&(Integers a, Integers b) { return {a.v & b.v}; }
  friend Integers operator|(Integers a, Integers b) { return {a.v | b.v}; }
  friend Integers operator^(Integers a, Integers b) { return {a.v ^ b.v}; }
};
// Integers with a sign, rounded to nearest.
inline Floats to_floats(Integers a) {
  return {__builtin_convertvector(a.with_sign(), Floats::Word::Real)};
}

// a b + c
inline Floats fused(Floats a, Floats b, Floats c) {
#if defined(__aarch64__)
  return {Floats::Word::Real(vfmaq_f32(float32x4_t(c.v), float32x4_t(a.v), float32x4_t(b.v)))};
#else
  return {Floats::Word::fused(a.v, b.v, c.v)};
#endif
}
inline Doubles fused(Doubles a, Doubles b, Doubles c) {
#if defined(__aarch64__)
  return {Doubles::Word::Real(vfmaq_f64(float64x2_t(c.v), float64x2_t(a.v), float64x2_t(b.v)))};
#else
  return {Doubles::Word::fused(a.v, b.v, c.v)};
#endif
}
template <class T>
Numbers<T> square_root(Numbers<T> a) {
#if defined(__aarch64__)
  if constexpr (sizeof(T) == 4) return {Floats::Word::Real(vsqrtq_f32(float32x4_t(a.v)))};
#elif defined(__wasm_simd128__)
  if constexpr (sizeof(T) == 4) return {Floats::Word::Real(wasm_f32x4_sqrt(v128_t(a.v)))};
#endif
  return {Numbers<T>::Word::square_root(a.v)};
}
// The larger and the smaller number; either of the two if one is NaN.
template <class T>
Numbers<T> larger(Numbers<T> a, Numbers<T> b) {
#if defined(__aarch64__)
  if constexpr (sizeof(T) == 4) return {Floats::Word::Real(vmaxq_f32(float32x4_t(a.v), float32x4_t(b.v)))};
#elif defined(__wasm_simd128__)
  if constexpr (sizeof(T) == 4) return {Floats::Word::Real(wasm_f32x4_pmax(v128_t(b.v), v128_t(a.v)))};
#endif
  return {Numbers<T>::Word::larger(a.v, b.v)};
}
inline Floats smaller(Floats a, Floats b) {
#if defined(__aarch64__)
  return {Floats::Word::Real(vminq_f32(float32x4_t(a.v), float32x4_t(b.v)))};
#elif defined(__wasm_simd128__)
  return {Floats::Word::Real(wasm_f32x4_pmin(v128_t(b.v), v128_t(a.v)))};
#else
  return {Floats::Word::smaller(a.v, b.v)};
#endif
}
// c in lanes where a > b, d in the others, also where a or b is NaN.
inline Floats where_greater(Floats a, Floats b, Floats c, Floats d) {
  return {Floats::Word::select(a.v > b.v, c.v, d.v)};
}
inline Floats magnitude(Floats a) {
  return {Floats::Word::absolute(a.v)};
}
// The size of one number with the sign of another.
inline Floats with_sign_of(Floats size, Floats sign) {
  using W = Floats::Word;
  return {W::number(W::bits(W::absolute(size.v)) | (W::bits(sign.v) & W::bits(W::all(-0.0F))))};
}

inline LaneBits equal(Integers a, Integers b) {
  return Floats::set_lanes(a.v == b.v);
}
inline LaneBits greater_signed(Integers a, Integers b) {
  return Floats::set_lanes(a.with_sign() > b.with_sign());
}
inline LaneBits sign_bits(Integers a) {
#if defined(__SSE2__)
  return Floats::set_lanes(a.with_sign());
#else
  return Floats::set_lanes(a.with_sign() < 0);
#endif
}
// By the sign bit: true for -0.
inline LaneBits negative(Floats a) {
  return sign_bits(Integers::bits_of(a));
}

// Counts in each lane how often a comparison holds.
template <class Lanes>
struct LaneCounts {
  typename Lanes::Word::Mask negative = {};

  void count_not_less(Lanes a, Lanes b) { negative += a.v >= b.v; }
  LaneBits equal(int32_t count) const { return Lanes::set_lanes(negative == -count); }
};

}  // namespace
}  // namespace hsp

#if defined(__AVX2__)
#include "lanes/words_32.hpp"
#else
#include "lanes/words_16.hpp"
#endif

namespace hsp {
namespace {

// The same as FourOfEach with integers, for the things with these numbers.
struct FourIntegersOfEach {
  Integers a, b, c, d;

  static FourIntegersOfEach at(const int32_t *p, const uint32_t *thing) {
    const FourOfEach bits = FourOfEach::of([p, thing](int k) {
      return Wide<float, 4>::load(reinterpret_cast<const float *>(p + 4 * uint64_t{thing[k]}));
    });
    return {Integers::bits_of(bits.a), Integers::bits_of(bits.b), Integers::bits_of(bits.c), Integers::bits_of(bits.d)};
  }
};

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
