// The words of words.hpp for registers of 32 bytes: eight floats, four doubles, eight integers, sixteen fractions.
//
// As an example the order that brings lanes 1 and 3 of four doubles to the front. The processor permutes words of 32
// bits, so that a double is a pair of these: pairs 1 and 3 are words 2, 3 and 6, 7.
//   front_orders.of_four[0b1010]           2  3  6  7  0  0  0  0
//   doubles                               10    11    12    13
//   in that order                         11    13    and anything in the other two lanes
// Lanes 1 and 3 of eight floats are words 1 and 3: front_orders.of_eight[0b1010] is 1 3 0 0 0 0 0 0.
#pragma once

#include <immintrin.h>

namespace hsp {
// Orders of lanes that bring the chosen ones to the front, for the processor's permutations. An order is eight bytes,
// which are widened when they are loaded. There is one table for all files.
struct FrontOrders {
  alignas(64) uint8_t of_eight[256][8];
  alignas(64) uint8_t of_four[16][8];  // of pairs of 32 bits

  constexpr FrontOrders() : of_eight{}, of_four{} {
    for (uint32_t chosen = 0; chosen < 256; ++chosen) {
      uint32_t to = 0;
      for (uint8_t lane = 0; lane < 8; ++lane) {
        if (chosen >> lane & 1U) of_eight[chosen][to++] = lane;
      }
    }
    for (uint32_t chosen = 0; chosen < 16; ++chosen) {
      uint32_t to = 0;
      for (uint8_t lane = 0; lane < 4; ++lane) {
        if ((chosen >> lane & 1U) == 0) continue;
        of_four[chosen][to++] = static_cast<uint8_t>(2 * lane);
        of_four[chosen][to++] = static_cast<uint8_t>(2 * lane + 1);
      }
    }
  }
};
inline constexpr FrontOrders front_orders;

namespace {

struct Floats {
  using Real = float;
  static constexpr uint32_t lanes = 8;
  __m256 v;

  static Floats load(const float *p) { return {_mm256_loadu_ps(p)}; }
  static Floats all(float x) { return {_mm256_set1_ps(x)}; }
  static Floats ascending() { return {_mm256_setr_ps(0, 1, 2, 3, 4, 5, 6, 7)}; }
  static Floats all_of(const float *p) { return {_mm256_broadcast_ss(p)}; }
  void store(float *p) const { _mm256_storeu_ps(p, v); }

  friend Floats operator+(Floats a, Floats b) { return {_mm256_add_ps(a.v, b.v)}; }
  friend Floats operator-(Floats a, Floats b) { return {_mm256_sub_ps(a.v, b.v)}; }
  friend Floats operator*(Floats a, Floats b) { return {_mm256_mul_ps(a.v, b.v)}; }
  friend Floats operator/(Floats a, Floats b) { return {_mm256_div_ps(a.v, b.v)}; }
  friend Floats operator-(Floats a) { return {_mm256_xor_ps(a.v, _mm256_set1_ps(-0.0F))}; }
};

struct Doubles {
  using Real = double;
  static constexpr uint32_t lanes = 4;
  __m256d v;

  static Doubles load(const double *p) { return {_mm256_loadu_pd(p)}; }
  static Doubles all(double x) { return {_mm256_set1_pd(x)}; }
  static Doubles ascending() { return {_mm256_setr_pd(0, 1, 2, 3)}; }
  static Doubles all_of(const double *p) { return {_mm256_broadcast_sd(p)}; }
  void store(double *p) const { _mm256_storeu_pd(p, v); }

  friend Doubles operator+(Doubles a, Doubles b) { return {_mm256_add_pd(a.v, b.v)}; }
  friend Doubles operator-(Doubles a, Doubles b) { return {_mm256_sub_pd(a.v, b.v)}; }
  friend Doubles operator*(Doubles a, Doubles b) { return {_mm256_mul_pd(a.v, b.v)}; }
  friend Doubles operator/(Doubles a, Doubles b) { return {_mm256_div_pd(a.v, b.v)}; }
  friend Doubles operator-(Doubles a) { return {_mm256_xor_pd(a.v, _mm256_set1_pd(-0.0))}; }
};

// Four numbers a, b, c, d of eight things; in memory the numbers of each thing are side by side.
struct FourOfEach {
  Floats a, b, c, d;

  static FourOfEach load(const float *p) {
    return of([p](int k) { return _mm_loadu_ps(p + 4 * k); });
  }

  // of_thing(k): the four numbers of thing k.
  template <class OfThing>
  static FourOfEach of(OfThing of_thing) {
    const auto things = [of_thing](int k) {  // k in the lower half, k + 4 in the upper one
      return _mm256_insertf128_ps(_mm256_castps128_ps256(of_thing(k)), of_thing(k + 4), 1);
    };
    const __m256 first = things(0), second = things(1), third = things(2), fourth = things(3);
    const __m256 ab01 = _mm256_unpacklo_ps(first, second), cd01 = _mm256_unpackhi_ps(first, second);
    const __m256 ab23 = _mm256_unpacklo_ps(third, fourth), cd23 = _mm256_unpackhi_ps(third, fourth);
    return {{_mm256_shuffle_ps(ab01, ab23, 0x44)},
            {_mm256_shuffle_ps(ab01, ab23, 0xEE)},
            {_mm256_shuffle_ps(cd01, cd23, 0x44)},
            {_mm256_shuffle_ps(cd01, cd23, 0xEE)}};
  }
};

struct Integers {
  static constexpr uint32_t lanes = 8;
  __m256i v;

  static Integers load(const uint32_t *p) { return {_mm256_loadu_si256(reinterpret_cast<const __m256i *>(p))}; }
  static Integers all(uint32_t x) { return {_mm256_set1_epi32(static_cast<int>(x))}; }
  static Integers ascending() { return {_mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7)}; }
  void store(uint32_t *p) const { _mm256_storeu_si256(reinterpret_cast<__m256i *>(p), v); }

  // All bits set in the lowest `count` lanes, none in the others.
  static Integers first_set(uint32_t count) { return {_mm256_cmpgt_epi32(all(count).v, ascending().v)}; }
  // All bits set in the lanes from `count` on, none in the others.
  static Integers all_set_from(uint32_t count) { return {_mm256_cmpgt_epi32(ascending().v, all(count - 1).v)}; }

  friend Integers operator+(Integers a, Integers b) { return {_mm256_add_epi32(a.v, b.v)}; }
  friend Integers operator-(Integers a, Integers b) { return {_mm256_sub_epi32(a.v, b.v)}; }
  friend Integers operator&(Integers a, Integers b) { return {_mm256_and_si256(a.v, b.v)}; }
  friend Integers operator|(Integers a, Integers b) { return {_mm256_or_si256(a.v, b.v)}; }
  friend Integers operator^(Integers a, Integers b) { return {_mm256_xor_si256(a.v, b.v)}; }
};

// The same as FourOfEach with integers, for the things with these numbers.
struct FourIntegersOfEach {
  Integers a, b, c, d;

  static FourIntegersOfEach at(const int32_t *p, const uint32_t *thing) {
    const FourOfEach bits = FourOfEach::of(
        [p, thing](int k) { return _mm_loadu_ps(reinterpret_cast<const float *>(p + 4 * uint64_t{thing[k]})); });
    return {{_mm256_castps_si256(bits.a.v)},
            {_mm256_castps_si256(bits.b.v)},
            {_mm256_castps_si256(bits.c.v)},
            {_mm256_castps_si256(bits.d.v)}};
  }
};
// Integers with a sign, rounded to nearest.
inline Floats to_floats(Integers a) {
  return {_mm256_cvtepi32_ps(a.v)};
}
// a in lanes whose bits are all set, b in those where none is.
inline Integers chosen(Integers all_or_none, Integers a, Integers b) {
  return {_mm256_blendv_epi8(b.v, a.v, all_or_none.v)};
}

// a b + c, a b - c and c - a b, rounded once.
inline Floats fused(Floats a, Floats b, Floats c) {
  return {_mm256_fmadd_ps(a.v, b.v, c.v)};
}
inline Floats fused_minus(Floats a, Floats b, Floats c) {
  return {_mm256_fmsub_ps(a.v, b.v, c.v)};
}
inline Floats minus_fused(Floats a, Floats b, Floats c) {
  return {_mm256_fnmadd_ps(a.v, b.v, c.v)};
}
inline Doubles fused(Doubles a, Doubles b, Doubles c) {
  return {_mm256_fmadd_pd(a.v, b.v, c.v)};
}
inline Doubles fused_minus(Doubles a, Doubles b, Doubles c) {
  return {_mm256_fmsub_pd(a.v, b.v, c.v)};
}
inline Doubles minus_fused(Doubles a, Doubles b, Doubles c) {
  return {_mm256_fnmadd_pd(a.v, b.v, c.v)};
}
// The difference with either sign: the one for which b may be read from memory.
inline Floats distance(Floats a, Floats b) {
  return a - b;
}
inline Floats square_root(Floats a) {
  return {_mm256_sqrt_ps(a.v)};
}
inline Doubles square_root(Doubles a) {
  return {_mm256_sqrt_pd(a.v)};
}

inline Floats larger(Floats a, Floats b) {
  return {_mm256_max_ps(a.v, b.v)};
}
inline Doubles larger(Doubles a, Doubles b) {
  return {_mm256_max_pd(a.v, b.v)};
}
inline Floats smaller(Floats a, Floats b) {
  return {_mm256_min_ps(a.v, b.v)};
}
inline double first(Doubles a) {
  return _mm256_cvtsd_f64(a.v);
}
// c in lanes where a > b, d in the others, also where a or b is NaN.
inline Floats where_greater(Floats a, Floats b, Floats c, Floats d) {
  return {_mm256_blendv_ps(d.v, c.v, _mm256_cmp_ps(a.v, b.v, _CMP_GT_OQ))};
}

// Eight doubles as floats, rounded to nearest.
inline Floats to_floats(Doubles low, Doubles high) {
  return {_mm256_set_m128(_mm256_cvtpd_ps(high.v), _mm256_cvtpd_ps(low.v))};
}

// Comparisons; all false for NaN.
inline LaneBits greater(Floats a, Floats b) {
  return static_cast<LaneBits>(_mm256_movemask_ps(_mm256_cmp_ps(a.v, b.v, _CMP_GT_OQ)));
}
inline LaneBits not_greater(Floats a, Floats b) {  // but true for NaN
  return static_cast<LaneBits>(_mm256_movemask_ps(_mm256_cmp_ps(a.v, b.v, _CMP_NGT_UQ)));
}
inline LaneBits not_less(Floats a, Floats b) {
  return static_cast<LaneBits>(_mm256_movemask_ps(_mm256_cmp_ps(a.v, b.v, _CMP_GE_OQ)));
}
inline LaneBits greater(Doubles a, Doubles b) {
  return static_cast<LaneBits>(_mm256_movemask_pd(_mm256_cmp_pd(a.v, b.v, _CMP_GT_OQ)));
}
inline LaneBits not_less(Doubles a, Doubles b) {
  return static_cast<LaneBits>(_mm256_movemask_pd(_mm256_cmp_pd(a.v, b.v, _CMP_GE_OQ)));
}

inline LaneBits equal(Integers a, Integers b) {
  return static_cast<LaneBits>(_mm256_movemask_ps(_mm256_castsi256_ps(_mm256_cmpeq_epi32(a.v, b.v))));
}

// The larger and the smaller of integers with a sign.
inline Integers larger_signed(Integers a, Integers b) {
  return {_mm256_max_epi32(a.v, b.v)};
}
inline Integers smaller_signed(Integers a, Integers b) {
  return {_mm256_min_epi32(a.v, b.v)};
}
inline LaneBits sign_bits(Integers a) {
  return static_cast<LaneBits>(_mm256_movemask_ps(_mm256_castsi256_ps(a.v)));
}
inline LaneBits greater_signed(Integers a, Integers b) {
  return sign_bits({_mm256_cmpgt_epi32(a.v, b.v)});
}
// Whether a > b in all lanes that are set in `set`.
inline bool all_greater(Integers a, Integers b, Integers set) {
  return _mm256_testc_si256(_mm256_cmpgt_epi32(a.v, b.v), set.v) != 0;
}
// In each lane the smaller of a and `partners`; the larger one in the lanes whose bits takes_larger has.
template <int takes_larger>
Integers exchange(Integers a, Integers partners) {
  return {_mm256_blend_epi32(smaller_signed(a, partners).v, larger_signed(a, partners).v, takes_larger)};
}
inline Integers with_next(Integers a) {  // 1 0 3 2 5 4 7 6
  return {_mm256_shuffle_epi32(a.v, 0xB1)};
}
inline Integers with_second_next(Integers a) {  // 2 3 0 1 6 7 4 5
  return {_mm256_shuffle_epi32(a.v, 0x4E)};
}
inline Integers with_fourth_next(Integers a) {  // 4 5 6 7 0 1 2 3
  return {_mm256_permute4x64_epi64(a.v, 0x4E)};
}
inline Integers reversed_fours(Integers a) {  // 3 2 1 0 7 6 5 4
  return {_mm256_shuffle_epi32(a.v, 0x1B)};
}
inline Integers reversed(Integers a) {
  return reversed_fours(with_fourth_next(a));
}

// Batcher's bitonic sorter (Knuth, TAOCP 3, section 5.3.4).
inline Integers sorted_halves(Integers a) {  // of eight lanes whose halves of four are bitonic
  a = exchange<0xCC>(a, with_second_next(a));
  return exchange<0xAA>(a, with_next(a));
}
inline Integers sorted_bitonic(Integers a) {
  return sorted_halves(exchange<0xF0>(a, with_fourth_next(a)));
}
inline Integers sorted(Integers a) {
  a = exchange<0xAA>(a, with_next(a));
  a = exchange<0xCC>(a, reversed_fours(a));
  a = exchange<0xAA>(a, with_next(a));
  return sorted_halves(exchange<0xF0>(a, reversed(a)));
}

// Stores the first `count` lanes alone.
inline void store_first(uint32_t *p, Integers a, uint32_t count) {
  _mm256_maskstore_epi32(reinterpret_cast<int *>(p), Integers::first_set(count).v, a.v);
}
// The upper 32 bits of eight doubles: sign, exponent and the first bits behind the point.
inline Integers upper_halves(Doubles low, Doubles high) {
  const __m256 pairs = _mm256_shuffle_ps(_mm256_castpd_ps(low.v), _mm256_castpd_ps(high.v), 0xDD);
  return {_mm256_permute4x64_epi64(_mm256_castps_si256(pairs), 0xD8)};
}

// By the sign bit: true for -0.
inline LaneBits negative(Floats a) {
  return static_cast<LaneBits>(_mm256_movemask_ps(a.v));
}
inline Floats magnitude(Floats a) {
  return {_mm256_andnot_ps(_mm256_set1_ps(-0.0F), a.v)};
}
// The size of one number with the sign of another.
inline Floats with_sign_of(Floats size, Floats sign) {
  const __m256 bit = _mm256_set1_ps(-0.0F);
  return {_mm256_or_ps(_mm256_andnot_ps(bit, size.v), _mm256_and_ps(bit, sign.v))};
}

template <>
struct LaneCounts<Floats> {
  __m256i negative = _mm256_setzero_si256();

  void count_not_less(Floats a, Floats b) {
    negative = _mm256_add_epi32(negative, _mm256_castps_si256(_mm256_cmp_ps(a.v, b.v, _CMP_GE_OQ)));
  }
  LaneBits equal(int32_t count) const {
    const __m256i same = _mm256_cmpeq_epi32(negative, _mm256_set1_epi32(-count));
    return static_cast<LaneBits>(_mm256_movemask_ps(_mm256_castsi256_ps(same)));
  }
};
template <>
struct LaneCounts<Doubles> {
  __m256i negative = _mm256_setzero_si256();

  void count_not_less(Doubles a, Doubles b) {
    negative = _mm256_add_epi64(negative, _mm256_castpd_si256(_mm256_cmp_pd(a.v, b.v, _CMP_GE_OQ)));
  }
  LaneBits equal(int32_t count) const {
    const __m256i same = _mm256_cmpeq_epi64(negative, _mm256_set1_epi64x(-count));
    return static_cast<LaneBits>(_mm256_movemask_pd(_mm256_castsi256_pd(same)));
  }
};

// Sixteen fractions from -1 to below 1, as multiples of 2^-15. Floats and sums outside this range become its ends;
// products are rounded to the nearest. The product of -1 and -1 is wrong.
struct Fractions {
  static constexpr uint32_t lanes = 16;
  __m256i v;

  static Fractions all(float x) { return {_mm256_set1_epi16(static_cast<int16_t>(x * 0x1p15F))}; }
  // Sixteen floats times a factor. The order of the lanes is known to the functions below alone.
  static Fractions of(Floats low, Floats high, float factor) {
    return {_mm256_packs_epi32(integers(low, factor), integers(high, factor))};
  }
  // Eight floats times a factor as fractions, each of them twice, for all_of().
  static Floats twice(Floats a, float factor) {
    const __m256i eight = integers(a, factor), fractions = _mm256_packs_epi32(eight, eight);
    return {_mm256_castsi256_ps(_mm256_unpacklo_epi16(fractions, fractions))};
  }
  static Fractions all_of(const float *twice) { return {_mm256_castps_si256(_mm256_broadcast_ss(twice))}; }

  // The fractions of the eight low floats, and of the eight high ones, as floats with the same signs.
  Floats signs_of_low() const { return {_mm256_castsi256_ps(_mm256_unpacklo_epi16(v, v))}; }
  Floats signs_of_high() const { return {_mm256_castsi256_ps(_mm256_unpackhi_epi16(v, v))}; }

  friend Fractions operator+(Fractions a, Fractions b) { return {_mm256_adds_epi16(a.v, b.v)}; }
  friend Fractions operator-(Fractions a, Fractions b) { return {_mm256_subs_epi16(a.v, b.v)}; }
  friend Fractions operator*(Fractions a, Fractions b) { return {_mm256_mulhrs_epi16(a.v, b.v)}; }

 private:
  static __m256i integers(Floats a, float factor) { return _mm256_cvtps_epi32((a * Floats::all(factor * 0x1p15F)).v); }
};
inline Fractions larger(Fractions a, Fractions b) {
  return {_mm256_max_epi16(a.v, b.v)};
}
inline Fractions smaller(Fractions a, Fractions b) {
  return {_mm256_min_epi16(a.v, b.v)};
}
// The size of fractions; -1 stays -1.
inline Fractions magnitude(Fractions a) {
  return {_mm256_abs_epi16(a.v)};
}

// The signs of sixteen fractions a and sixteen fractions b.
struct FractionSigns {
  __m256i v;

  static FractionSigns all_negative() { return {_mm256_set1_epi8(-1)}; }
  static FractionSigns of(Fractions a, Fractions b) { return {_mm256_packs_epi16(a.v, b.v)}; }
  friend FractionSigns either_negative(FractionSigns a, FractionSigns b) { return {_mm256_or_si256(a.v, b.v)}; }
  friend FractionSigns both_negative(FractionSigns a, FractionSigns b) { return {_mm256_and_si256(a.v, b.v)}; }
  // The lanes, of the eight low floats and of the eight high ones, whose fraction is negative in a or in b.
  void negative(LaneBits &low, LaneBits &high) const {
    // In each half of the register are four low and four high fractions of a, then those of b.
    const LaneBits bits = static_cast<LaneBits>(_mm256_movemask_epi8(v)), either = bits | bits >> 8;
    low = (either & 15U) | (either >> 12 & 0xF0U);
    high = (either >> 4 & 15U) | (either >> 16 & 0xF0U);
  }
};

// An order that brings the chosen lanes to the front, of eight floats or integers or of four doubles. It may serve
// several stores.
struct FrontOrder {
  __m256i v;

  static FrontOrder of(LaneBits chosen) { return of_eight(chosen); }
  static FrontOrder of_eight(LaneBits chosen) { return widened(front_orders.of_eight[chosen]); }
  static FrontOrder of_four(LaneBits chosen) { return widened(front_orders.of_four[chosen]); }
  static FrontOrder widened(const uint8_t *order) {
    return {_mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i *>(order)))};
  }
};
// The order for lanes of this kind.
template <class Lanes>
FrontOrder front_order(LaneBits chosen) {
  if constexpr (Lanes::lanes == 8) {
    return FrontOrder::of_eight(chosen);
  } else {
    return FrontOrder::of_four(chosen);
  }
}
inline Floats lanes_in_order(Floats a, FrontOrder order) {
  return {_mm256_permutevar8x32_ps(a.v, order.v)};
}
// Up to eight numbers, from which any eight can be taken, in any order.
struct EightFloats {
  Floats numbers;

  static EightFloats load(const float *p) { return {Floats::load(p)}; }
  Floats in_order(const uint8_t *order) const { return lanes_in_order(numbers, FrontOrder::widened(order)); }
};
// Stores the chosen lanes at the front; there must be room for all lanes.
inline void store_front(float *p, Floats a, FrontOrder order) {
  lanes_in_order(a, order).store(p);
}
inline void store_front(double *p, Doubles a, FrontOrder order) {
  _mm256_storeu_pd(p, _mm256_castsi256_pd(_mm256_permutevar8x32_epi32(_mm256_castpd_si256(a.v), order.v)));
}
inline void store_front(uint32_t *p, Integers a, FrontOrder order) {
  _mm256_storeu_si256(reinterpret_cast<__m256i *>(p), _mm256_permutevar8x32_epi32(a.v, order.v));
}

}  // namespace
}  // namespace hsp
