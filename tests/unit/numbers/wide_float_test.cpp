// Wide floats, held against schoolbook integers without a limit: what is claimed of an error is true, signs that are
// certain are right, few are not, and limbs of both widths give the same bits.
#include "numbers/wide_float.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "big_integer.hpp"
#include "random_balls.hpp"
#include "sweep_length.hpp"

namespace {

using oracle::BigInteger;
using Narrow = hsp::WideFloatOf<uint32_t>;
#if defined(__SIZEOF_INT128__)
using Broad = hsp::WideFloatOf<uint64_t>;
#else
using Broad = Narrow;
#endif

// The integer of a float's mantissa with its sign, and the exponent of its last bit.
template <class Float>
BigInteger mantissa(const Float &a, int64_t &exponent) {
  BigInteger sum;
  for (uint32_t k = 0; k < a.words(); ++k) sum = sum.times_power_of_two(64) + BigInteger(oracle::Int128{a.word(k)});
  int32_t top = 0;
  const double leading = a.leading(top);
  exponent = int64_t{top} - 64 * int64_t{a.words()};
  return leading < 0.0 ? -sum : sum;
}

BigInteger magnitude(const BigInteger &a) {
  return a.sign() < 0 ? -a : a;
}
BigInteger times_power(const BigInteger &a, int64_t bits) {
  return a.times_power_of_two(static_cast<unsigned>(bits));
}
bool at_most(const BigInteger &a, const BigInteger &b) {
  return (b - a).sign() >= 0;
}

// The same number by both kinds of limbs, and numerator / denominator exactly.
struct Triple {
  Broad broad;
  Narrow narrow;
  BigInteger numerator, denominator;
};

Triple integer(int64_t value, uint32_t bits) {
  return {Broad(value, bits), Narrow(value, bits), BigInteger(value), BigInteger(1)};
}
Triple operator+(const Triple &a, const Triple &b) {
  return {a.broad + b.broad, a.narrow + b.narrow, a.numerator * b.denominator + b.numerator * a.denominator,
          a.denominator * b.denominator};
}
Triple operator-(const Triple &a, const Triple &b) {
  return {a.broad - b.broad, a.narrow - b.narrow, a.numerator * b.denominator - b.numerator * a.denominator,
          a.denominator * b.denominator};
}
Triple operator*(const Triple &a, const Triple &b) {
  return {a.broad * b.broad, a.narrow * b.narrow, a.numerator * b.numerator, a.denominator * b.denominator};
}
Triple operator/(const Triple &a, const Triple &b) {
  const bool negative = b.numerator.sign() < 0;
  return {a.broad / b.broad, a.narrow / b.narrow, a.numerator * (negative ? -b.denominator : b.denominator),
          a.denominator * magnitude(b.numerator)};
}

void expect_same_bits(const Broad &a, const Narrow &b) {
  int32_t exponent = 0, other = 0;
  ASSERT_EQ(a.leading(exponent), b.leading(other));
  ASSERT_EQ(exponent, other);
  ASSERT_EQ(a.error_exponent(), b.error_exponent());
  ASSERT_EQ(a.words(), b.words());
  ASSERT_EQ(a.sign(), b.sign());
  for (uint32_t k = 0; k < a.words(); ++k) ASSERT_EQ(a.word(k), b.word(k));
}

// |m 2^e - n / d| <= 2^f as |m d 2^(e - s) - n 2^(-s)| <= d 2^(f - s), s the smallest of the exponents and 0.
void expect_within_error(const Broad &ours, const BigInteger &numerator, const BigInteger &denominator) {
  int64_t exponent = 0;
  const BigInteger m = mantissa(ours, exponent);
  if (ours.words() == 0) exponent = 0;
  // A product with an exact 0 has an error of some bits more than none.
  const bool exact = ours.error_exponent() <= Broad::exact / 2;
  const int64_t error = exact ? 0 : ours.error_exponent();
  ASSERT_LT(error, 10000);
  const int64_t least = std::min({exponent, error, int64_t{0}});
  const BigInteger off = magnitude(times_power(m, exponent - least) * denominator - times_power(numerator, -least));
  ASSERT_TRUE(at_most(off, exact ? BigInteger() : times_power(denominator, error - least)));
}

void expect_right(const Triple &a) {
  ASSERT_NO_FATAL_FAILURE(expect_same_bits(a.broad, a.narrow));
  ASSERT_NO_FATAL_FAILURE(expect_within_error(a.broad, a.numerator, a.denominator));
  if (a.broad.sign() != 0) {
    ASSERT_EQ(a.broad.sign(), a.numerator.sign());
  }
}

int64_t draw(oracle::RandomSource &random) {
  const int64_t one = INT64_C(1) << random.in(0, 61), sign = random.one_in(2) ? 1 : -1;
  return sign * (random.one_in(3) ? one : random.one_in(2) ? one - 1 : random.in(0, one));
}

uint32_t width(oracle::RandomSource &random) {
  constexpr uint32_t widths[] = {64, 128, 384, 448, 832, 1600, 2048};
  return widths[random.in(0, 6)];
}

// Sums, products and quotients of up to ten integers in any order.
Triple expression(oracle::RandomSource &random, uint32_t bits) {
  Triple a = integer(draw(random), bits);
  for (int64_t k = random.in(1, 9); k > 0; --k) {
    const Triple b = integer(draw(random), bits);
    switch (random.in(0, 5)) {
      case 0:
        a = a + b;
        break;
      case 1:
        a = b - a;
        break;
      case 2:
        a = a * a;
        break;
      case 3:
        a = b.broad.sign() != 0 ? a / b : a;
        break;
      default:
        a = a * b;
        break;
    }
    // Twice as long at most: below 2^4096.
    if (at_most(BigInteger(1).times_power_of_two(1984), magnitude(a.numerator)) ||
        at_most(BigInteger(1).times_power_of_two(1984), a.denominator)) {
      break;
    }
  }
  return a;
}

TEST(WideFloat, ExpressionsOfIntegers) {
  oracle::RandomSource random(1);
  for (int turn = 0; turn < oracle::rounds(250, 1000000); ++turn) {
    ASSERT_NO_FATAL_FAILURE(expect_right(expression(random, width(random))));
  }
}

// (a + b)^2 - a^2 - 2 a b - b^2 + c, of which nothing but c is left: its sign is certain wherever the first terms are
// less than so many bits longer.
TEST(WideFloat, WhatCancels) {
  oracle::RandomSource random(2);
  int uncertain = 0, certain = 0;
  for (int turn = 0; turn < oracle::rounds(400, 100000); ++turn) {
    const uint32_t bits = width(random);
    const Triple a = integer(draw(random), bits) * integer(draw(random), bits);
    const Triple b = integer(draw(random), bits), two = integer(2, bits);
    const int64_t left = random.one_in(3) ? 0 : draw(random);
    const Triple sum = a + b;
    const Triple rest = sum * sum - a * a - two * a * b - b * b + integer(left, bits);
    ASSERT_NO_FATAL_FAILURE(expect_right(rest));
    ASSERT_EQ(rest.numerator.sign(), left > 0 ? 1 : left < 0 ? -1 : 0);
    if (left != 0 && bits >= 384) {
      ASSERT_NE(rest.broad.sign(), 0);
    }
    ++(rest.broad.sign() == 0 && left != 0 ? uncertain : certain);
  }
  EXPECT_GT(uncertain, 0);
  EXPECT_GT(certain, uncertain);
}

// A quotient times its divisor, and a root times itself: both are off by no more than the bounds allow, and these are
// not much larger than they have to be.
TEST(WideFloat, QuotientsAndRoots) {
  oracle::RandomSource random(3);
  for (int turn = 0; turn < oracle::rounds(250, 300000); ++turn) {
    const uint32_t bits = width(random);
    const Triple a = integer(draw(random), bits) * integer(draw(random), bits), b = integer(draw(random), bits);
    if (b.numerator.sign() == 0 || a.numerator.sign() == 0) continue;
    const Triple quotient = a / b;
    ASSERT_NO_FATAL_FAILURE(expect_right(quotient));
    int32_t top = 0;
    quotient.broad.leading(top);
    // Of what is exact, or of products of two integers that 64 bits hold no more than in part.
    if (bits >= 128) {
      ASSERT_LE(quotient.broad.error_exponent(), top - static_cast<int32_t>(bits) + 20);
    }
    // |x - r| <= f with x the root of a: as r - f <= x <= r + f, squared.
    const Triple positive = {a.broad.sign() < 0 ? -a.broad : a.broad, a.narrow.sign() < 0 ? -a.narrow : a.narrow,
                             magnitude(a.numerator), BigInteger(1)};
    if (positive.broad.sign() == 0) continue;
    const Broad root = square_root(positive.broad);
    ASSERT_NO_FATAL_FAILURE(expect_same_bits(root, square_root(positive.narrow)));
    ASSERT_EQ(root.sign(), 1);
    int64_t exponent = 0;
    const BigInteger r = mantissa(root, exponent);
    const int64_t least = std::min({exponent, int64_t{root.error_exponent()}, int64_t{0}});
    const BigInteger scaled = times_power(r, exponent - least);
    const BigInteger error = times_power(BigInteger(1), root.error_exponent() - least);
    const BigInteger low = scaled - error, high = scaled + error;
    const BigInteger square = times_power(positive.numerator, -2 * least);
    ASSERT_TRUE(at_most(low * low, square) && at_most(square, high * high));
    root.leading(top);
    if (bits >= 128) {
      ASSERT_LE(root.error_exponent(), top - static_cast<int32_t>(bits) + 20);
    }
  }
}

// Of numbers that fill all of their bits, and are taken as exact: what is left out of a product is within its bound.
TEST(WideFloat, ProductsOfWholeLengths) {
  oracle::RandomSource random(5);
  for (int turn = 0; turn < oracle::rounds(60, 20000); ++turn) {
    const uint32_t bits = width(random);
    Triple a = integer(draw(random), bits) / integer(draw(random), bits);
    Triple b = integer(draw(random), bits) / integer(draw(random), bits);
    a = {a.broad.exact_in(bits), a.narrow.exact_in(bits), {}, {}};
    b = {b.broad.exact_in(bits), b.narrow.exact_in(bits), {}, {}};
    ASSERT_NO_FATAL_FAILURE(expect_same_bits(a.broad * b.broad, a.narrow * b.narrow));
    int64_t exponent = 0, other = 0;
    const BigInteger product = mantissa(a.broad, exponent) * mantissa(b.broad, other);
    const int64_t low = exponent + other;
    ASSERT_NO_FATAL_FAILURE(expect_within_error(a.broad * b.broad, times_power(product, std::max(low, int64_t{0})),
                                                times_power(BigInteger(1), std::max(-low, int64_t{0}))));
  }
}

// Errors go into every result, and doubles say the same.
TEST(WideFloat, ErrorsAreHandedOn) {
  oracle::RandomSource random(4);
  for (int turn = 0; turn < oracle::rounds(60, 100000); ++turn) {
    const Triple a = expression(random, 128), b = expression(random, 128);
    ASSERT_NO_FATAL_FAILURE(expect_right(a * b));
    ASSERT_NO_FATAL_FAILURE(expect_right(a - b));
    ASSERT_NO_FATAL_FAILURE(expect_right(a + b));
    if (b.broad.sign() != 0) {
      ASSERT_NO_FATAL_FAILURE(expect_right(a / b));
    }
    const hsp::BoundedDouble rounded(a.broad);
    int32_t top = 0;
    const double leading = a.broad.leading(top);
    if (top < 900 && top > -900) {
      ASSERT_LE(std::fabs(rounded.value - std::ldexp(leading, top)), rounded.error);
      ASSERT_GE(rounded.error,
                a.broad.error_exponent() <= Broad::exact ? 0.0 : std::ldexp(1.0, a.broad.error_exponent()));
      if (rounded.sign() != 0) {
        ASSERT_EQ(rounded.sign(), a.numerator.sign());
      }
    }
  }
}

TEST(WideFloat, NothingIsCertainOfWhatIsNotDefined) {
  const Broad zero, one(1, 384), minus(-1, 384);
  EXPECT_EQ(zero.sign(), 0);
  EXPECT_EQ(one.sign(), 1);
  EXPECT_EQ(minus.sign(), -1);
  EXPECT_EQ((one - one).sign(), 0);
  EXPECT_EQ((one / zero).sign(), 0);
  EXPECT_EQ((one / (one - one)).sign(), 0);
  EXPECT_EQ(square_root(zero).sign(), 0);
  EXPECT_EQ(square_root(minus).sign(), 0);
  EXPECT_EQ((one / zero + one).sign(), 0);
  EXPECT_EQ((one / zero * zero).sign(), 0);
  EXPECT_EQ((one / zero / one).sign(), 0);
  EXPECT_EQ(square_root(one / zero + one).sign(), 0);
  EXPECT_EQ(hsp::BoundedDouble(one / zero).sign(), 0);
  EXPECT_EQ(hsp::BoundedDouble(one.scaled(-2000)).sign(), 0);
  EXPECT_EQ(hsp::BoundedDouble(one.scaled(2000)).sign(), 0);
  EXPECT_EQ(hsp::BoundedDouble(one.scaled(-1)).value, 0.5);
  EXPECT_EQ((one.scaled(3) - Broad(8, 384)).sign(), 0);
  EXPECT_EQ((one.scaled(3) - Broad(7, 384)).sign(), 1);
}

}  // namespace
