// The oracles' integers of any size against known powers, 128-bit arithmetic and the laws of a ring; and the order of
// the infinitesimals.
#include "big_integer.hpp"

#include <gtest/gtest.h>

#include "infinitesimal.hpp"
#include "random_balls.hpp"

namespace {

using namespace oracle;

BigInteger big(Int128 value) {
  return BigInteger(value);
}

BigInteger power(const BigInteger &base, int exponent) {
  BigInteger result = big(1);
  for (int k = 0; k < exponent; ++k) result = result * base;
  return result;
}

TEST(BigInteger, PrintsKnownPowers) {
  EXPECT_EQ(big(0).to_string(), "0");
  EXPECT_EQ(big(-1).to_string(), "-1");
  EXPECT_EQ(power(big(2), 100).to_string(), "1267650600228229401496703205376");
  EXPECT_EQ(power(big(-3), 81).to_string(), "-443426488243037769948249630619149892803");
  EXPECT_EQ(big(1).times_power_of_two(128).to_string(), "340282366920938463463374607431768211456");
}

TEST(BigInteger, AgreesWithBuiltInArithmetic) {
  RandomSource random(1);
  for (int k = 0; k < 20000; ++k) {
    // Differences of all magnitudes around the limbs' borders.
    const Int128 a = Int128{random.in(-1000, 1000)} << random.in(0, 50);
    const Int128 b = (Int128{random.in(-3, 3)} << random.in(0, 60)) + random.in(-1, 1);
    EXPECT_EQ(big(a) + big(b), big(a + b));
    EXPECT_EQ(big(a) - big(b), big(a - b));
    EXPECT_EQ(big(a) * big(b), big(a * b));
    EXPECT_EQ(big(a).sign(), (a > 0) - (a < 0));
  }
}

TEST(BigInteger, ObeysTheLawsOfARing) {
  RandomSource random(2);
  const auto large = [&] {
    BigInteger value = big(random.in(-9, 9));
    for (int64_t k = random.in(0, 9); k > 0; --k)
      value = value * big(Int128{random.in(-(int64_t{1} << 60), int64_t{1} << 60)}) + big(random.in(-1, 1));
    return value;
  };
  for (int k = 0; k < 2000; ++k) {
    const BigInteger a = large();
    const BigInteger b = large();
    const BigInteger c = large();
    EXPECT_EQ((a + b) * c, a * c + b * c);
    EXPECT_EQ((a * b) * c, a * (b * c));
    EXPECT_EQ((a - b) + b, a);
    EXPECT_EQ((a - a).sign(), 0);
    EXPECT_EQ((a * b).sign(), a.sign() * b.sign());
  }
}

TEST(Infinitesimal, OrdersMonomialsBySmallestInfinitesimalFirst) {
  const auto number = [](Int128 value) { return Infinitesimal(value); };
  const Infinitesimal e0 = Infinitesimal::epsilon(0);
  const Infinitesimal e1 = Infinitesimal::epsilon(1);
  const Infinitesimal e3 = Infinitesimal::epsilon(3);
  EXPECT_EQ((number(1) - number(1000000) * e0).sign(), +1);
  EXPECT_EQ((e0 * e0 * e0 - number(1000000) * e1).sign(), +1);
  EXPECT_EQ((e0 * e3 - e1 * e1 * e1).sign(), -1);
  EXPECT_EQ((number(5) * e1 - number(7) * e1 * e1).sign(), +1);
  EXPECT_EQ(((e0 + e1) * (e0 - e1) - e0 * e0 + e1 * e1).sign(), 0);
  EXPECT_EQ((number(3) * e3 - number(2) * e3 - e3).sign(), 0);
}

}  // namespace
