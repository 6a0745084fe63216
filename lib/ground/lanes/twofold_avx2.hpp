// Numbers that are the sum of two doubles, four at a time: for polynomials in integers that are to be rounded once,
// with 106 bits where the integers of wide_integer.hpp have all. For files *_avx2.cpp alone; everything has internal
// linkage.
//
// Sums are split exactly and products by a fused operation; the second parts are rounded. Where a bound of what that
// leaves out is known, rounded_within() tells whether the exact number would be rounded to the same double.
#pragma once

#include "lanes/words.hpp"

namespace hsp {
namespace {

struct Twofold {
  Doubles high, low;
};

// Exactly, for integers below 2^63 in size; the second part has at most 2^-53 times the size of both.
inline Twofold from(LongIntegers a) {
  Twofold result{};
  result.high = to_doubles(a, result.low);
  return result;
}

// a + b, exact in any order of size.
inline Twofold exact_sum(Doubles a, Doubles b) {
  const Doubles sum = a + b;
  const Doubles of_b = sum - a;
  return {sum, (a - (sum - of_b)) + (b - of_b)};
}
inline Twofold exact_square(Doubles a) {
  const Doubles high = a * a;
  return {high, fused_minus(a, a, high)};
}

// Without the square of the second part.
inline Twofold square(const Twofold &a) {
  const Twofold of_high = exact_square(a.high);
  return {of_high.high, fused(a.high + a.high, a.low, of_high.low)};
}
inline Twofold product(const Twofold &a, Doubles b) {
  const Doubles high = a.high * b;
  return {high, fused(a.low, b, fused_minus(a.high, b, high))};
}
// Without the product of the second parts.
inline Twofold product(const Twofold &a, const Twofold &b) {
  const Doubles high = a.high * b.high;
  return {high, fused(a.low, b.high, fused(a.high, b.low, fused_minus(a.high, b.high, high)))};
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
inline Twofold difference_of_products(const Twofold &a, Doubles b, const Twofold &c, Doubles d) {
  return difference(product(a, b), product(c, d));
}

// The lanes in which every number as near to a as the error is rounded to the same double; `rounded` is a, and its
// first part the double nearest to it.
inline LaneBits rounded_within(const Twofold &a, Doubles error, Twofold &rounded) {
  rounded = exact_sum(a.high, a.low);
  const Doubles above = rounded.high + (rounded.low + error);
  const Doubles below = rounded.high + (rounded.low - error);
  return not_less(below, above);
}

}  // namespace
}  // namespace hsp
