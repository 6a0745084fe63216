// Numbers that are the sum of two doubles (double-double arithmetic), four at a time: for polynomials in integers that
// are to be rounded once. They have 106 bits, while the integers of wide_integer.hpp have all bits. Everything has
// internal linkage.
//
// They need fused products, and only in registers of four doubles they are faster than integers of 128 bits.
//
// Sums are split exactly, and products by a fused operation; the second parts are rounded. If a bound of the error is
// known, rounded_within() tells whether the exact number would be rounded to the same double.
#pragma once

#include "lanes/four_doubles.hpp"

namespace hsp {
namespace {

#if defined(__FMA__)
inline constexpr bool has_twofold = register_lanes == 4;
#else
inline constexpr bool has_twofold = false;
#endif

struct Twofold {
  FourDoubles high, low;
};

// Exact, for integers below 2^63 in size; the second part has at most 2^-53 times the size of the number.
inline Twofold from(LongIntegers a) {
  Twofold result{};
  result.high = to_doubles(a, result.low);
  return result;
}

// a + b, exact whichever is larger.
inline Twofold exact_sum(FourDoubles a, FourDoubles b) {
  const FourDoubles sum = a + b;
  const FourDoubles of_b = sum - a;
  return {sum, (a - (sum - of_b)) + (b - of_b)};
}
inline Twofold exact_square(FourDoubles a) {
  const FourDoubles high = a * a;
  return {high, Four::fused(a, a, -high)};
}

// The square of the second part is left out.
inline Twofold square(const Twofold &a) {
  const Twofold of_high = exact_square(a.high);
  return {of_high.high, Four::fused(a.high + a.high, a.low, of_high.low)};
}
inline Twofold product(const Twofold &a, FourDoubles b) {
  const FourDoubles high = a.high * b;
  return {high, Four::fused(a.low, b, Four::fused(a.high, b, -high))};
}
// The product of the second parts is left out.
inline Twofold product(const Twofold &a, const Twofold &b) {
  const FourDoubles high = a.high * b.high;
  return {high, Four::fused(a.low, b.high, Four::fused(a.high, b.low, Four::fused(a.high, b.high, -high)))};
}

inline Twofold difference(const Twofold &a, const Twofold &b) {
  const Twofold sum = exact_sum(a.high, -b.high);
  return {sum.high, sum.low + (a.low - b.low)};
}
inline Twofold sum_of_three(const Twofold &a, const Twofold &b, const Twofold &c) {
  const Twofold two = exact_sum(a.high, b.high);
  const Twofold three = exact_sum(two.high, c.high);
  return {three.high, (two.low + three.low) + (a.low + b.low + c.low)};
}
inline Twofold sum_of_squares(const Twofold &a, const Twofold &b, const Twofold &c) {
  return sum_of_three(square(a), square(b), square(c));
}
inline Twofold difference_of_products(const Twofold &a, FourDoubles b, const Twofold &c, FourDoubles d) {
  return difference(product(a, b), product(c, d));
}

// The lanes in which all numbers from a - error to a + error are rounded to the same double. `rounded` becomes a, with
// the double nearest to a as its first part.
inline LaneBits rounded_within(const Twofold &a, FourDoubles error, Twofold &rounded) {
  rounded = exact_sum(a.high, a.low);
  const FourDoubles above = rounded.high + (rounded.low + error);
  const FourDoubles below = rounded.high + (rounded.low - error);
  return lanes_where(below >= above);
}

}  // namespace
}  // namespace hsp
