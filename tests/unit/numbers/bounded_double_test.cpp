// Doubles with error bounds: the exact number is within the bound, and signs that are certain are right.
#include "numbers/bounded_double.hpp"

#include <gtest/gtest.h>

#include "int128.hpp"
#include "long_reals.hpp"
#include "random_balls.hpp"

namespace {

using hsp::BoundedDouble;

TEST(BoundedDouble, PolynomialsOfIntegers) {
  oracle::RandomSource random(1);
  int uncertain = 0;
  for (int turn = 0; turn < 20000; ++turn) {
    const int64_t size = INT64_C(1) << random.in(2, 30);
    const auto draw = [&] { return random.in(-size, size); };
    const int64_t a = draw(), b = draw(), c = draw(), d = random.one_in(4) ? b : draw();
    const auto number = [](int64_t x) { return BoundedDouble(static_cast<double>(x)); };
    // a (b - d) (b + d) + c c a, whose products are below 2^93.
    const oracle::Int128 exact =
        oracle::Int128{a} * (oracle::Int128{b} * b - oracle::Int128{d} * d) + oracle::Int128{c} * c * a;
    const BoundedDouble ours =
        number(a) * (number(b) * number(b) - number(d) * number(d)) + number(c) * number(c) * number(a);
    // The difference of an integer and a double of up to 2^93, exactly.
    const oracle::Int128 rounded = static_cast<oracle::Int128>(ours.value);
    const oracle::Int128 off = exact > rounded ? exact - rounded : rounded - exact;
    ASSERT_LE(static_cast<double>(off), ours.error * (1 + 0x1p-40) + 1.0);
    if (ours.sign() != 0) {
      ASSERT_EQ(ours.sign(), oracle::sign_of(exact));
    } else {
      ++uncertain;
    }
  }
  EXPECT_LT(uncertain, 3000);
}

TEST(BoundedDouble, QuotientsAndRoots) {
  if (!oracle::has_long_reals) GTEST_SKIP();
  oracle::RandomSource random(2);
  for (int turn = 0; turn < 20000; ++turn) {
    const auto draw = [&] {
      const double value = static_cast<double>(random.in(-1000000, 1000000)) / 1024.0;
      return BoundedDouble(value, std::fabs(value) * 0x1p-20);
    };
    const BoundedDouble a = draw(), b = draw();
    for (const int end : {-1, 1}) {
      for (const int other : {-1, 1}) {
        const long double x = static_cast<long double>(a.value) + end * static_cast<long double>(a.error);
        const long double y = static_cast<long double>(b.value) + other * static_cast<long double>(b.error);
        if (b.value != 0.0) {
          const BoundedDouble quotient = a / b;
          ASSERT_LE(std::fabs(x / y - quotient.value), quotient.error);
          // And not by much more than it has to be.
          ASSERT_LE(quotient.error, std::fabs(quotient.value) * 0x1p-18 + 1e-300);
        }
        if (a.value > 0.0) {
          const BoundedDouble root = square_root(a);
          ASSERT_LE(std::fabs(std::sqrt(x) - root.value), root.error);
        }
      }
    }
  }
}

TEST(BoundedDouble, NothingIsCertainOfWhatIsNotDefined) {
  const BoundedDouble zero(0.0, 1.0), one(1.0);
  EXPECT_EQ((one / zero).sign(), 0);
  EXPECT_EQ(square_root(zero).sign(), 0);
  EXPECT_EQ(square_root(BoundedDouble(-1.0)).sign(), 0);
  EXPECT_EQ((one / zero + one).sign(), 0);
  EXPECT_EQ((one / zero * BoundedDouble(0.0)).sign(), 0);
  EXPECT_EQ(one.sign(), 1);
  EXPECT_EQ((-one).sign(), -1);
  EXPECT_EQ(BoundedDouble(0.0).sign(), 0);
}

}  // namespace
