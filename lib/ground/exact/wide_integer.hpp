// Signed integers of a fixed number of bits, in two's complement with little-endian limbs. They use no heap and no
// exceptions; the caller guarantees that values fit (the bit bounds are in plane.hpp). 32-bit limbs work everywhere;
// 64-bit limbs need the compiler's 128-bit product.
//
// As an example numbers of 64 bits in limbs of 32, the lowest first:
//   2^40      0x00000000 0x00000100
//   -1        0xFFFFFFFF 0xFFFFFFFF
//   -2^40     0x00000000 0xFFFFFF00      the highest bit of the last limb is the sign
#pragma once

#include <bit>
#include <cstdint>

namespace hsp::exact {

template <class Limb>
struct DoubleLimb;
template <>
struct DoubleLimb<uint32_t> {
  using type = uint64_t;
};
#if defined(__SIZEOF_INT128__)
__extension__ typedef unsigned __int128 uint128;
template <>
struct DoubleLimb<uint64_t> {
  using type = uint128;
};
#endif

// The limb that the library itself uses.
#if defined(__SIZEOF_INT128__) && !defined(HSP_PORTABLE_LIMBS)
using FastLimb = uint64_t;
#else
using FastLimb = uint32_t;
#endif

template <class Limb, int bits>
struct WideInteger {
  using Wide = typename DoubleLimb<Limb>::type;
  static constexpr int limb_bits = static_cast<int>(sizeof(Limb) * 8);
  static constexpr int limbs = (bits + limb_bits - 1) / limb_bits;
  Limb limb[limbs];

  static constexpr WideInteger from(int64_t value) {
    WideInteger result{};
    const uint64_t pattern = static_cast<uint64_t>(value);
    const Limb extension = value < 0 ? static_cast<Limb>(~Limb{0}) : Limb{0};
    for (int k = 0; k < limbs; ++k) {
      result.limb[k] = k * limb_bits < 64 ? static_cast<Limb>(pattern >> (k * limb_bits)) : extension;
    }
    return result;
  }
  constexpr bool negative() const { return (limb[limbs - 1] >> (limb_bits - 1)) != 0; }
  constexpr int sign() const {
    if (negative()) return -1;
    Limb any = 0;
    for (int k = 0; k < limbs; ++k) any |= limb[k];
    return any != 0 ? 1 : 0;
  }
  friend constexpr WideInteger operator+(const WideInteger &a, const WideInteger &b) {
    WideInteger result{};
    Wide carry = 0;
    for (int k = 0; k < limbs; ++k) {
      carry += static_cast<Wide>(a.limb[k]) + b.limb[k];
      result.limb[k] = static_cast<Limb>(carry);
      carry >>= limb_bits;
    }
    return result;
  }
  friend constexpr WideInteger operator-(const WideInteger &a, const WideInteger &b) {
    WideInteger result{};
    Wide carry = 1;
    for (int k = 0; k < limbs; ++k) {
      carry += static_cast<Wide>(a.limb[k]) + static_cast<Limb>(~b.limb[k]);
      result.limb[k] = static_cast<Limb>(carry);
      carry >>= limb_bits;
    }
    return result;
  }
  constexpr WideInteger operator-() const { return WideInteger{} - *this; }

  // The nearest double: the leading 64 significant bits are kept, the rest as a sticky bit alone, then one rounding.
  // The result does not depend on the limb width. Out of line: rarely needed, and longer than what calls it.
  [[gnu::noinline]] double to_double() const {
    const bool is_negative = negative();
    const WideInteger absolute = is_negative ? -*this : *this;
    int top = limbs - 1;
    while (top >= 0 && absolute.limb[top] == 0) --top;
    if (top < 0) return 0.0;
    const int spare = std::countl_zero(absolute.limb[top]);
    const int length = (top + 1) * limb_bits - spare;
    const int shift = length > 64 ? length - 64 : 0;
    uint64_t leading = 0;
    Limb lost = 0;
    if constexpr (limb_bits == 64) {
      const Limb next = top > 0 ? absolute.limb[top - 1] : 0;
      // With one limb nothing is shifted out: this limb is the leading part.
      leading = spare == 0 || top == 0 ? absolute.limb[top] : absolute.limb[top] << spare | next >> (64 - spare);
      lost = next << spare;
      for (int k = 0; k < top - 1; ++k) lost |= absolute.limb[k];
    } else {
      for (int k = 0; k <= top; ++k) {
        const int left = k * limb_bits - shift;
        if (left <= -limb_bits) {
          lost |= absolute.limb[k];
        } else if (left < 0) {
          leading |= static_cast<uint64_t>(absolute.limb[k]) >> -left;
          lost |= static_cast<Limb>(absolute.limb[k] << (limb_bits + left));
        } else {
          leading |= static_cast<uint64_t>(absolute.limb[k]) << left;
        }
      }
    }
    const double result = static_cast<double>(leading | (lost != 0 ? 1U : 0U)) * power_of_two(shift);
    return is_negative ? -result : result;
  }

 private:
  // 2^exponent for 0 <= exponent < 1023, from the bits of the format.
  static constexpr double power_of_two(int exponent) {
    return std::bit_cast<double>(static_cast<uint64_t>(exponent + 1023) << 52);
  }
};

#if defined(__SIZEOF_INT128__)
template <int bits>
constexpr uint128 sign_extended(const WideInteger<uint64_t, bits> &a) {
  if constexpr (WideInteger<uint64_t, bits>::limbs == 1) {
    return static_cast<uint128>(static_cast<int64_t>(a.limb[0]));
  } else {
    return static_cast<uint128>(a.limb[1]) << 64 | a.limb[0];
  }
}
#endif

// The product, truncated to `out` bits: schoolbook multiplication of unsigned limbs, then one conditional subtraction
// for each negative factor, since the bit pattern of a negative number is its value plus 2^width. If both factors are
// negative, 2^(sum of both widths) is left over, which lies beyond `out` bits.
template <int out, class Limb, int a_bits, int b_bits>
constexpr WideInteger<Limb, out> product(const WideInteger<Limb, a_bits> &a, const WideInteger<Limb, b_bits> &b) {
  using Result = WideInteger<Limb, out>;
  using Wide = typename Result::Wide;
  constexpr int na = WideInteger<Limb, a_bits>::limbs;
  constexpr int nb = WideInteger<Limb, b_bits>::limbs;
  constexpr int n = Result::limbs;
  constexpr int w = Result::limb_bits;
  static_assert(n <= na + nb);
  Result result{};
#if defined(__SIZEOF_INT128__)
  // Up to the width of the result, a product in two's complement does not depend on whether its factors are signed, so
  // the compiler's unsigned type suffices.
  if constexpr (sizeof(Limb) == 8 && n == 2 && na <= 2 && nb <= 2) {
    const uint128 whole = sign_extended(a) * sign_extended(b);
    result.limb[0] = static_cast<Limb>(whole);
    result.limb[1] = static_cast<Limb>(whole >> 64);
    return result;
  }
#endif
  for (int i = 0; i < na && i < n; ++i) {
    Wide carry = 0;
    int j = 0;
    for (; j < nb && i + j < n; ++j) {
      carry += static_cast<Wide>(a.limb[i]) * b.limb[j] + result.limb[i + j];
      result.limb[i + j] = static_cast<Limb>(carry);
      carry >>= w;
    }
    if (i + j < n) result.limb[i + j] = static_cast<Limb>(carry);
  }
  const auto subtract_at = [&result](int first, const auto &value, int value_limbs) {
    Wide carry = 1;
    for (int k = first; k < n; ++k) {
      const Limb limb = k - first < value_limbs ? value.limb[k - first] : Limb{0};
      carry += static_cast<Wide>(result.limb[k]) + static_cast<Limb>(~limb);
      result.limb[k] = static_cast<Limb>(carry);
      carry >>= w;
    }
  };
  if (a.negative()) subtract_at(na, b, nb);
  if (b.negative()) subtract_at(nb, a, na);
  return result;
}

}  // namespace hsp::exact
