// The words of words.hpp for registers of 16 bytes: four floats, two doubles, eight fractions. Where the compiler's own
// code is worse, instructions of SSE2 and its followers up to x86-64-v2, of NEON and of WebAssembly are used; without
// any of these the results are the same.
//
// As an example four floats, lanes 0 to 3:
//   a                           5   1   7   3
//   b                           4   4   4   4
//   greater(a, b)               1   0   1   0     as LaneBits 5
//   store_front(p, a, FrontOrder::of(5))          p[0] = 5, p[1] = 7, and anything in p[2] and p[3]
// So the numbers above a limit are picked from an array without a branch on them: four are loaded and stored in this
// way, and p moves on by ones().
#pragma once

namespace hsp {
namespace {

// Four numbers a, b, c, d of four things; in memory the numbers of each thing are side by side.
struct FourOfEach {
  Floats a, b, c, d;

  static FourOfEach load(const float *p) {
#if defined(__aarch64__)
    const float32x4x4_t apart = vld4q_f32(p);
    using Real = Floats::Word::Real;
    return {{Real(apart.val[0])}, {Real(apart.val[1])}, {Real(apart.val[2])}, {Real(apart.val[3])}};
#else
    return of([p](int k) { return Floats::load(p + 4 * k).v; });
#endif
  }
  // of_thing(k): the four numbers of thing k.
  template <class OfThing>
  static FourOfEach of(OfThing of_thing) {
    const auto first = of_thing(0), second = of_thing(1), third = of_thing(2), fourth = of_thing(3);
    const auto ab01 = __builtin_shufflevector(first, second, 0, 4, 1, 5);
    const auto cd01 = __builtin_shufflevector(first, second, 2, 6, 3, 7);
    const auto ab23 = __builtin_shufflevector(third, fourth, 0, 4, 1, 5);
    const auto cd23 = __builtin_shufflevector(third, fourth, 2, 6, 3, 7);
    return {{__builtin_shufflevector(ab01, ab23, 0, 1, 4, 5)},
            {__builtin_shufflevector(ab01, ab23, 2, 3, 6, 7)},
            {__builtin_shufflevector(cd01, cd23, 0, 1, 4, 5)},
            {__builtin_shufflevector(cd01, cd23, 2, 3, 6, 7)}};
  }
};

// a in lanes whose bits are all set, b in those where none is.
inline Integers chosen(Integers all_or_none, Integers a, Integers b) {
  return {b.v ^ ((a.v ^ b.v) & all_or_none.v)};
}

// a b - c and c - a b
inline Floats fused_minus(Floats a, Floats b, Floats c) {
#if defined(__aarch64__)
  return fused(a, b, -c);
#else
  return {a.v * b.v - c.v};
#endif
}
inline Floats minus_fused(Floats a, Floats b, Floats c) {
#if defined(__aarch64__)
  return {Floats::Word::Real(vfmsq_f32(float32x4_t(c.v), float32x4_t(a.v), float32x4_t(b.v)))};
#else
  return {c.v - a.v * b.v};
#endif
}
inline Doubles fused_minus(Doubles a, Doubles b, Doubles c) {
  return fused(a, b, {-c.v});
}
// The difference with either sign: the one for which a may stay in a register.
inline Floats distance(Floats a, Floats b) {
  return b - a;
}
// Four doubles as floats, rounded to nearest.
inline Floats to_floats(Doubles low, Doubles high) {
#if defined(__SSE2__)
  return {Floats::Word::Real(_mm_movelh_ps(_mm_cvtpd_ps(__m128d(low.v)), _mm_cvtpd_ps(__m128d(high.v))))};
#elif defined(__aarch64__)
  return {Floats::Word::Real(vcvt_high_f32_f64(vcvt_f32_f64(float64x2_t(low.v)), float64x2_t(high.v)))};
#else
  return {Floats::Word::Real{static_cast<float>(low.v[0]), static_cast<float>(low.v[1]), static_cast<float>(high.v[0]),
                             static_cast<float>(high.v[1])}};
#endif
}

// True for NaN.
inline LaneBits not_greater(Floats a, Floats b) {
  return Floats::set_lanes(~(a.v > b.v));
}

// The larger and the smaller of integers with a sign.
inline Integers larger_signed(Integers a, Integers b) {
  return Integers::of(a.with_sign() > b.with_sign() ? a.with_sign() : b.with_sign());
}
inline Integers smaller_signed(Integers a, Integers b) {
  return Integers::of(a.with_sign() < b.with_sign() ? a.with_sign() : b.with_sign());
}
// Whether a > b in all lanes that are set in `set`.
inline bool all_greater(Integers a, Integers b, Integers set) {
  return Floats::set_lanes(set.with_sign() & ~(a.with_sign() > b.with_sign())) == 0;
}
// In each lane the smaller of a and `partners`; the larger one in lanes where takes_larger is -1.
inline Integers exchange(Integers a, Integers partners, const Integers::Signed &takes_larger) {
  return chosen(Integers::of((a.with_sign() > partners.with_sign()) ^ takes_larger), partners, a);
}
inline Integers with_next(Integers a) {
  return {__builtin_shufflevector(a.v, a.v, 1, 0, 3, 2)};
}
inline Integers reversed(Integers a) {
  return {__builtin_shufflevector(a.v, a.v, 3, 2, 1, 0)};
}
// Batcher's bitonic sorter (Knuth, TAOCP 3, section 5.3.4).
inline Integers sorted_bitonic(Integers a) {
  a = exchange(a, {__builtin_shufflevector(a.v, a.v, 2, 3, 0, 1)}, Integers::Signed{0, 0, -1, -1});
  return exchange(a, with_next(a), Integers::Signed{0, -1, 0, -1});
}
inline Integers sorted(Integers a) {
  a = exchange(a, with_next(a), Integers::Signed{0, -1, 0, -1});
  a = exchange(a, reversed(a), Integers::Signed{0, 0, -1, -1});
  return exchange(a, with_next(a), Integers::Signed{0, -1, 0, -1});
}

// Stores the first `count` lanes alone.
inline void store_first(uint32_t *p, Integers a, uint32_t count) {
  for (uint32_t k = 0; k < count && k < Integers::lanes; ++k) p[k] = a.v[k];
}
// The upper 32 bits of four doubles: sign, exponent and the first bits behind the point.
inline Integers upper_halves(Doubles low, Doubles high) {
  return {__builtin_shufflevector(reinterpret_cast<Integers::Bits>(low.v), reinterpret_cast<Integers::Bits>(high.v), 1,
                                  3, 5, 7)};
}

struct Fractions {
  typedef int16_t Word __attribute__((vector_size(16)));
  static constexpr uint32_t lanes = 8;
  Word v;

  static Fractions all(float x) {
    const int16_t s = static_cast<int16_t>(x * 0x1p15F);
    return {Word{s, s, s, s, s, s, s, s}};
  }
  static Fractions of(Floats low, Floats high, float factor) {
    return packed(integers(low, factor), integers(high, factor));
  }
  static Floats twice(Floats a, float factor) {
    const Signed four = integers(a, factor);
    const Word fractions = packed(four, four).v;
    return {reinterpret_cast<Floats::Word::Real>(Word{fractions[0], fractions[0], fractions[1], fractions[1],
                                                      fractions[2], fractions[2], fractions[3], fractions[3]})};
  }
  static Fractions all_of(const float *twice) { return {reinterpret_cast<Word>(Floats::Word::all(*twice))}; }

  Floats signs_of_low() const {
    return {reinterpret_cast<Floats::Word::Real>(Word{v[0], v[0], v[1], v[1], v[2], v[2], v[3], v[3]})};
  }
  Floats signs_of_high() const {
    return {reinterpret_cast<Floats::Word::Real>(Word{v[4], v[4], v[5], v[5], v[6], v[6], v[7], v[7]})};
  }

  friend Fractions operator+(Fractions a, Fractions b) {
#if defined(__SSE2__)
    return {Word(_mm_adds_epi16(__m128i(a.v), __m128i(b.v)))};
#elif defined(__aarch64__)
    return {Word(vqaddq_s16(int16x8_t(a.v), int16x8_t(b.v)))};
#elif defined(__wasm_simd128__)
    return {Word(wasm_i16x8_add_sat(v128_t(a.v), v128_t(b.v)))};
#else
    return each(a, b, [](int32_t x, int32_t y) { return x + y; });
#endif
  }
  friend Fractions operator-(Fractions a, Fractions b) {
#if defined(__SSE2__)
    return {Word(_mm_subs_epi16(__m128i(a.v), __m128i(b.v)))};
#elif defined(__aarch64__)
    return {Word(vqsubq_s16(int16x8_t(a.v), int16x8_t(b.v)))};
#elif defined(__wasm_simd128__)
    return {Word(wasm_i16x8_sub_sat(v128_t(a.v), v128_t(b.v)))};
#else
    return each(a, b, [](int32_t x, int32_t y) { return x - y; });
#endif
  }
  friend Fractions operator*(Fractions a, Fractions b) {
#if defined(__SSSE3__)
    return {Word(_mm_mulhrs_epi16(__m128i(a.v), __m128i(b.v)))};
#elif defined(__SSE2__)
    // Twice the upper half of the product, and the two bits below it rounded to one.
    const __m128i high = _mm_mulhi_epi16(__m128i(a.v), __m128i(b.v));
    const __m128i below = _mm_srli_epi16(_mm_mullo_epi16(__m128i(a.v), __m128i(b.v)), 14);
    return {Word(_mm_add_epi16(_mm_add_epi16(high, high), _mm_avg_epu16(below, _mm_setzero_si128())))};
#elif defined(__aarch64__)
    return {Word(vqrdmulhq_s16(int16x8_t(a.v), int16x8_t(b.v)))};
#elif defined(__wasm_simd128__)
    return {Word(wasm_i16x8_q15mulr_sat(v128_t(a.v), v128_t(b.v)))};
#else
    return each(a, b, [](int32_t x, int32_t y) { return (x * y + 0x4000) >> 15; });
#endif
  }

 private:
  using Signed = Floats::Word::Mask;

  static Signed integers(Floats a, float factor) {
    const Floats scaled = a * Floats::all(factor * 0x1p15F);
#if defined(__SSE2__)
    return Signed(_mm_cvtps_epi32(__m128(scaled.v)));
#elif defined(__aarch64__)
    return Signed(vcvtnq_s32_f32(float32x4_t(scaled.v)));
#elif defined(__wasm_simd128__)
    return Signed(wasm_i32x4_trunc_sat_f32x4(wasm_f32x4_nearest(v128_t(scaled.v))));
#else
    // The sum has no bits behind the binary point, and no number here that matters is larger than 2^20.
    const Floats near = (scaled + Floats::all(0x1.8p23F)) - Floats::all(0x1.8p23F);
    return __builtin_convertvector(near.v, Signed);
#endif
  }
  static Fractions packed(Signed low, Signed high) {
#if defined(__SSE2__)
    return {Word(_mm_packs_epi32(__m128i(low), __m128i(high)))};
#elif defined(__aarch64__)
    return {Word(vqmovn_high_s32(vqmovn_s32(int32x4_t(low)), int32x4_t(high)))};
#elif defined(__wasm_simd128__)
    return {Word(wasm_i16x8_narrow_i32x4(v128_t(low), v128_t(high)))};
#else
    Fractions a{};
    for (uint32_t k = 0; k < 4; ++k) {
      a.v[k] = saturated(low[k]);
      a.v[k + 4] = saturated(high[k]);
    }
    return a;
#endif
  }
  static int16_t saturated(int32_t x) {
    return static_cast<int16_t>(x < -0x8000 ? -0x8000 : x > 0x7FFF ? 0x7FFF : x);
  }
  template <class Operation>
  static Fractions each(Fractions a, Fractions b, Operation operation) {
    for (uint32_t k = 0; k < lanes; ++k) a.v[k] = saturated(operation(a.v[k], b.v[k]));
    return a;
  }
};
inline Fractions larger(Fractions a, Fractions b) {
#if defined(__SSE2__)
  return {Fractions::Word(_mm_max_epi16(__m128i(a.v), __m128i(b.v)))};
#else
  return {a.v > b.v ? a.v : b.v};
#endif
}
inline Fractions smaller(Fractions a, Fractions b) {
#if defined(__SSE2__)
  return {Fractions::Word(_mm_min_epi16(__m128i(a.v), __m128i(b.v)))};
#else
  return {a.v < b.v ? a.v : b.v};
#endif
}
// The size of fractions; -1 stays -1.
inline Fractions magnitude(Fractions a) {
#if defined(__SSSE3__)
  return {Fractions::Word(_mm_abs_epi16(__m128i(a.v)))};
#elif defined(__aarch64__)
  return {Fractions::Word(vabsq_s16(int16x8_t(a.v)))};
#else
  typedef uint16_t Unsigned __attribute__((vector_size(16)));
  return larger(a, {reinterpret_cast<Fractions::Word>(Unsigned{} - reinterpret_cast<Unsigned>(a.v))});
#endif
}

// The signs of eight fractions a and eight fractions b.
struct FractionSigns {
  typedef int8_t Word __attribute__((vector_size(16)));
  Word v;

  static FractionSigns all_negative() { return {~Word{}}; }
  static FractionSigns of(Fractions a, Fractions b) {
#if defined(__SSE2__)
    return {Word(_mm_packs_epi16(__m128i(a.v), __m128i(b.v)))};
#elif defined(__aarch64__)
    return {Word(vqmovn_high_s16(vqmovn_s16(int16x8_t(a.v)), int16x8_t(b.v)))};
#elif defined(__wasm_simd128__)
    return {Word(wasm_i8x16_narrow_i16x8(v128_t(a.v), v128_t(b.v)))};
#else
    FractionSigns signs{};
    for (uint32_t k = 0; k < 8; ++k) {
      signs.v[k] = static_cast<int8_t>(a.v[k] < 0 ? -1 : 0);
      signs.v[k + 8] = static_cast<int8_t>(b.v[k] < 0 ? -1 : 0);
    }
    return signs;
#endif
  }
  friend FractionSigns either_negative(FractionSigns a, FractionSigns b) {
    return {static_cast<Word>(a.v | b.v)};
  }
  friend FractionSigns both_negative(FractionSigns a, FractionSigns b) {
    return {static_cast<Word>(a.v & b.v)};
  }
  // The lanes, of the four low floats and of the four high ones, whose fraction is negative in a or in b.
  void negative(LaneBits &low, LaneBits &high) const {
#if defined(__SSE2__)
    const LaneBits bits = static_cast<LaneBits>(_mm_movemask_epi8(__m128i(v))), either = bits | bits >> 8;
#elif defined(__aarch64__)
    constexpr uint8_t bit[8] = {1, 2, 4, 8, 16, 32, 64, 128};
    const int8x8_t any = vorr_s8(vget_low_s8(int8x16_t(v)), vget_high_s8(int8x16_t(v)));
    const LaneBits either = vaddv_u8(vand_u8(vcltz_s8(any), vld1_u8(bit)));
#elif defined(__wasm_simd128__)
    const LaneBits bits = wasm_i8x16_bitmask(v128_t(v)), either = bits | bits >> 8;
#else
    LaneBits either = 0;
    for (uint32_t k = 0; k < 16; ++k) either |= (v[k] < 0 ? 1U : 0U) << k % 8;
#endif
    low = either & 15U;
    high = either >> 4 & 15U;
  }
};

// An order of four lanes that brings the chosen ones to the front. It may serve several stores.
#if defined(__SSSE3__) || defined(__aarch64__) || defined(__wasm_simd128__)
struct FrontOrders {
  alignas(64) uint8_t bytes[16][16];

  constexpr FrontOrders() : bytes{} {
    for (uint32_t chosen = 0; chosen < 16; ++chosen) {
      uint32_t to = 0;
      for (uint32_t byte = 0; byte < 16; ++byte) {
        if (chosen >> byte / 4 & 1U) bytes[chosen][to++] = static_cast<uint8_t>(byte);
      }
    }
  }
};
constexpr FrontOrders front_orders;

struct FrontOrder {
  const uint8_t *bytes;

  static FrontOrder of(LaneBits chosen) { return {front_orders.bytes[chosen]}; }
};
// Stores the chosen lanes at the front; there must be room for all lanes.
inline void store_front(float *p, Floats a, FrontOrder order) {
#if defined(__SSSE3__)
  const __m128i bytes = _mm_load_si128(reinterpret_cast<const __m128i *>(order.bytes));
  _mm_storeu_ps(p, _mm_castsi128_ps(_mm_shuffle_epi8(_mm_castps_si128(__m128(a.v)), bytes)));
#elif defined(__wasm_simd128__)
  wasm_v128_store(p, wasm_i8x16_swizzle(v128_t(a.v), wasm_v128_load(order.bytes)));
#else
  vst1q_f32(p, vreinterpretq_f32_u8(vqtbl1q_u8(vreinterpretq_u8_f32(float32x4_t(a.v)), vld1q_u8(order.bytes))));
#endif
}
inline void store_front(uint32_t *p, Integers a, FrontOrder order) {
  float in_order[4];
  store_front(in_order, {reinterpret_cast<Floats::Word::Real>(a.v)}, order);
  std::memcpy(p, in_order, sizeof in_order);
}
#else
// The place to which each lane goes; lane 0 is always stored at place 0, and before the others.
struct FrontOrders {
  alignas(64) uint8_t to[16][4];

  constexpr FrontOrders() : to{} {
    for (uint32_t chosen = 0; chosen < 16; ++chosen) {
      for (uint32_t lane = 1; lane < 4; ++lane) {
        to[chosen][lane] = static_cast<uint8_t>(to[chosen][lane - 1] + (chosen >> (lane - 1) & 1U));
      }
    }
  }
};
constexpr FrontOrders front_orders;

struct FrontOrder {
  const uint8_t *to;

  static FrontOrder of(LaneBits chosen) { return {front_orders.to[chosen]}; }
};
template <class T, class Word>
void store_each(T *p, const Word &a, FrontOrder order) {
  p[0] = a[0];
  for (uint32_t k = 1; k < 4; ++k) p[order.to[k]] = a[k];
}
inline void store_front(float *p, Floats a, FrontOrder order) {
  store_each(p, a.v, order);
}
inline void store_front(uint32_t *p, Integers a, FrontOrder order) {
  store_each(p, a.v, order);
}
#endif
template <class>
FrontOrder front_order(LaneBits chosen) {
  return FrontOrder::of(chosen);
}

// Up to eight numbers, from which any four can be taken.
struct EightFloats {
  const float *p;

  static EightFloats load(const float *p) { return {p}; }
  Floats in_order(const uint8_t *order) const {
    return {Floats::Word::Real{p[order[0]], p[order[1]], p[order[2]], p[order[3]]}};
  }
};

}  // namespace
}  // namespace hsp
