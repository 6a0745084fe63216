// The words of words.hpp for registers of 32 bytes: eight floats, four doubles, eight integers, sixteen fractions.
//
// As an example the order that brings lanes 1 and 3 of four doubles to the front. The processor permutes words of 32
// bits, so that a double is a pair of these: pairs 1 and 3 are words 2, 3 and 6, 7.
//   front_orders.of_four[0b1010]           2  3  6  7  0  0  0  0
//   doubles                               10    11    12    13
//   in that order                         11    13    and anything in the other two lanes
// Lanes 1 and 3 of eight floats are words 1 and 3: front_orders.of_eight[0b1010] is 1 3 0 0 0 0 0 0.
#pragma once

#include "lanes/wide.hpp"

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

// Four numbers a, b, c, d of eight things; in memory the numbers of each thing are side by side.
struct FourOfEach {
  Floats a, b, c, d;

  static FourOfEach load(const float *p) {
    return of([p](int k) { return Wide<float, 4>::load(p + 4 * k); });
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

// Integers in the processor's own type.
inline __m256i bits(Integers a) {
  return __m256i(a.v);
}
inline Integers integers(__m256i a) {
  return {Integers::Bits(a)};
}
// a in lanes whose bits are all set, b in those where none is.
inline Integers chosen(Integers all_or_none, Integers a, Integers b) {
  return integers(_mm256_blendv_epi8(bits(b), bits(a), bits(all_or_none)));
}

// a b - c and c - a b
inline Floats fused_minus(Floats a, Floats b, Floats c) {
  return {_mm256_fmsub_ps(a.v, b.v, c.v)};
}
inline Floats minus_fused(Floats a, Floats b, Floats c) {
  return {_mm256_fnmadd_ps(a.v, b.v, c.v)};
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
// Eight doubles as floats, rounded to nearest.
inline Floats to_floats(Doubles low, Doubles high) {
  return {_mm256_set_m128(_mm256_cvtpd_ps(high.v), _mm256_cvtpd_ps(low.v))};
}

// True for NaN.
inline LaneBits not_greater(Floats a, Floats b) {
  return static_cast<LaneBits>(_mm256_movemask_ps(_mm256_cmp_ps(a.v, b.v, _CMP_NGT_UQ)));
}

// The larger and the smaller of integers with a sign.
inline Integers larger_signed(Integers a, Integers b) {
  return integers(_mm256_max_epi32(bits(a), bits(b)));
}
inline Integers smaller_signed(Integers a, Integers b) {
  return integers(_mm256_min_epi32(bits(a), bits(b)));
}
// Whether a > b in all lanes that are set in `set`.
inline bool all_greater(Integers a, Integers b, Integers set) {
  return _mm256_testc_si256(_mm256_cmpgt_epi32(bits(a), bits(b)), bits(set)) != 0;
}
// In each lane the smaller of a and `partners`; the larger one in the lanes whose bits takes_larger has.
template <int takes_larger>
Integers exchange(Integers a, Integers partners) {
  return integers(
      _mm256_blend_epi32(bits(smaller_signed(a, partners)), bits(larger_signed(a, partners)), takes_larger));
}
inline Integers with_next(Integers a) {  // 1 0 3 2 5 4 7 6
  return integers(_mm256_shuffle_epi32(bits(a), 0xB1));
}
inline Integers with_second_next(Integers a) {  // 2 3 0 1 6 7 4 5
  return integers(_mm256_shuffle_epi32(bits(a), 0x4E));
}
inline Integers with_fourth_next(Integers a) {  // 4 5 6 7 0 1 2 3
  return integers(_mm256_permute4x64_epi64(bits(a), 0x4E));
}
inline Integers reversed_fours(Integers a) {  // 3 2 1 0 7 6 5 4
  return integers(_mm256_shuffle_epi32(bits(a), 0x1B));
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
  _mm256_maskstore_epi32(reinterpret_cast<int *>(p), bits(Integers::first_set(count)), bits(a));
}
// The upper 32 bits of eight doubles: sign, exponent and the first bits behind the point.
inline Integers upper_halves(Doubles low, Doubles high) {
  const __m256 pairs = _mm256_shuffle_ps(_mm256_castpd_ps(low.v), _mm256_castpd_ps(high.v), 0xDD);
  return integers(_mm256_permute4x64_epi64(_mm256_castps_si256(pairs), 0xD8));
}

// Sixteen fractions from -1 to below 1, as multiples of 2^-15. Floats and sums outside this range become its ends;
// products are rounded to the nearest. The product of -1 and -1 is wrong.
struct Fractions {
  static constexpr uint32_t lanes = 16;
  __m256i v;

  static Fractions all(float x) { return {_mm256_set1_epi16(static_cast<int16_t>(x * 0x1p15F))}; }
  // Sixteen floats times a factor. The order of the lanes is known to the functions below alone.
  static Fractions of(Floats low, Floats high, float factor) {
    return {_mm256_packs_epi32(rounded(low, factor), rounded(high, factor))};
  }
  // Eight floats times a factor as fractions, each of them twice, for all_of().
  static Floats twice(Floats a, float factor) {
    const __m256i eight = rounded(a, factor), fractions = _mm256_packs_epi32(eight, eight);
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
  static __m256i rounded(Floats a, float factor) { return _mm256_cvtps_epi32((a * Floats::all(factor * 0x1p15F)).v); }
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
  integers(_mm256_permutevar8x32_epi32(bits(a), order.v)).store(p);
}

}  // namespace
}  // namespace hsp
