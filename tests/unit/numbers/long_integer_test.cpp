// Long integers, held against schoolbook arithmetic without a limit.
#include "numbers/long_integer.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "big_integer.hpp"
#include "random_balls.hpp"

namespace {

using LongInteger = hsp::LongInteger<1856>;
using oracle::BigInteger;

struct Pair {
  LongInteger ours;
  BigInteger exact;
};

// Of so many factors of up to 62 bits; with long runs of ones and zeros, where carries go far.
Pair draw(oracle::RandomSource &random, int64_t factors) {
  Pair number{LongInteger(1), BigInteger(1)};
  for (int64_t k = 0; k < factors; ++k) {
    const int64_t bits = random.in(0, 62), sign = random.one_in(2) ? 1 : -1;
    const int64_t one = INT64_C(1) << bits;
    const int64_t factor = sign * (random.one_in(3) ? one : random.one_in(2) ? one - 1 : random.in(0, one));
    number.ours = number.ours * LongInteger(factor);
    number.exact = number.exact * BigInteger(factor);
  }
  return number;
}

void expect_equal(const LongInteger &ours, const BigInteger &exact) {
  ASSERT_EQ(ours.sign(), exact.sign());
  int exponent = 0;
  const double mantissa = ours.leading(exponent);
  const std::string digits = exact.to_string();
  ASSERT_EQ(mantissa < 0.0, digits[0] == '-');
  if (exponent < 800) {
    ASSERT_EQ(std::ldexp(mantissa, exponent), std::strtod(digits.c_str(), nullptr));
  }
}

TEST(LongInteger, SumsAndProducts) {
  oracle::RandomSource random(1);
  for (int turn = 0; turn < 4000; ++turn) {
    const Pair a = draw(random, random.in(0, 12)), b = draw(random, random.in(0, 12));
    ASSERT_NO_FATAL_FAILURE(expect_equal(a.ours + b.ours, a.exact + b.exact));
    ASSERT_NO_FATAL_FAILURE(expect_equal(a.ours - b.ours, a.exact - b.exact));
    ASSERT_NO_FATAL_FAILURE(expect_equal(a.ours * b.ours, a.exact * b.exact));
    ASSERT_NO_FATAL_FAILURE(expect_equal(-a.ours, -a.exact));
    // (a + b)^2 = a^2 + 2 a b + b^2, to the last bit.
    const LongInteger sum = a.ours + b.ours;
    ASSERT_EQ((sum * sum - a.ours * a.ours - b.ours * b.ours - LongInteger(2) * a.ours * b.ours).sign(), 0);
    // Of shorter ones.
    const int64_t short_factor = random.in(-1000000000, 1000000000);
    const hsp::LongInteger<128> shorter = hsp::LongInteger<128>(short_factor) * hsp::LongInteger<128>(short_factor - 1);
    ASSERT_EQ((LongInteger(shorter) - LongInteger(short_factor) * LongInteger(short_factor - 1)).sign(), 0);
    // One more or one less is noticed.
    const LongInteger product = a.ours * b.ours;
    ASSERT_EQ((product + LongInteger(1) - product).sign(), 1);
    ASSERT_EQ((product - LongInteger(1) - product).sign(), -1);
  }
}

TEST(LongInteger, SmallOnes) {
  EXPECT_EQ(LongInteger().sign(), 0);
  EXPECT_EQ((-LongInteger()).sign(), 0);
  EXPECT_EQ(LongInteger(INT64_MIN).sign(), -1);
  EXPECT_EQ((LongInteger(INT64_MIN) + LongInteger(INT64_MAX) + LongInteger(1)).sign(), 0);
  int exponent = 0;
  EXPECT_EQ(std::ldexp(LongInteger(-3).leading(exponent), exponent), -3.0);
  EXPECT_EQ(LongInteger(0).leading(exponent), 0.0);
}

// The widest products that tangent_point.hpp asks for.
TEST(LongInteger, HasRoomForItsBits) {
  LongInteger power(1);
  for (uint32_t k = 0; k + 1 < 1856; ++k) power = power + power;
  const LongInteger half = power - LongInteger(1);
  EXPECT_EQ((power - half).sign(), 1);
  EXPECT_EQ((half + LongInteger(1) - power).sign(), 0);
}

}  // namespace
