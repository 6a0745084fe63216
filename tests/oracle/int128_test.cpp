// The oracles' own 128-bit integers of two words, for compilers without such a type: against known powers, and against
// the compiler's 128-bit integers where it has them.
#include "int128.hpp"

#include <gtest/gtest.h>

#include "big_integer.hpp"
#include "random_balls.hpp"

namespace {

using namespace oracle;

using Signed = TwoWords<true>;
using Unsigned = TwoWords<false>;

// Decimal digits, through halves.
template <bool has_sign>
std::string text_of(const TwoWords<has_sign> &value) {
  const auto half = [](const TwoWords<has_sign> &word) {
    const uint64_t bits = static_cast<uint64_t>(word);
    return BigInteger(static_cast<int64_t>(bits >> 32)).times_power_of_two(32) +
           BigInteger(static_cast<int64_t>(bits & 0xFFFFFFFFU));
  };
  BigInteger sum = half(value >> 64).times_power_of_two(64) + half(value);
  if (has_sign && value < TwoWords<has_sign>(0)) sum = sum - BigInteger(1).times_power_of_two(128);
  return sum.to_string();
}

TEST(TwoWords, HaveKnownPowers) {
  Signed power = 1;
  for (int k = 0; k < 80; ++k) power *= -3;
  EXPECT_EQ(text_of(power), "147808829414345923316083210206383297601");
  EXPECT_EQ(text_of(-power), "-147808829414345923316083210206383297601");
  EXPECT_EQ(text_of(Unsigned(1) << 127), "170141183460469231731687303715884105728");
  EXPECT_EQ(text_of(Signed(1) << 127), "-170141183460469231731687303715884105728");
  EXPECT_EQ(text_of(Unsigned(0) - 1), "340282366920938463463374607431768211455");
  EXPECT_EQ(text_of(Signed(-0x1p100)), "-1267650600228229401496703205376");
  EXPECT_EQ(text_of(Signed(-2.75)), "-2");
  EXPECT_EQ(static_cast<double>(Signed(1) << 127), -0x1p127);
  EXPECT_EQ(static_cast<double>(Unsigned(1) << 127), 0x1p127);
}

#ifdef __SIZEOF_INT128__
template <class Number, class Native>
void expect_same(const Number &value, Native native) {
  EXPECT_EQ(static_cast<uint64_t>(value), static_cast<uint64_t>(native));
  EXPECT_EQ(static_cast<uint64_t>(value >> 64), static_cast<uint64_t>(native >> 64));
}

// Numbers of all sizes, and those around 0, 2^63, 2^64 and 2^127.
template <class Number, class Native>
void compare_with_native() {
  RandomSource random(1);
  const auto word = [&] { return random.in(INT64_MIN / 2, INT64_MAX / 2) * 2 + random.in(0, 1); };
  const auto next = [&](Number &number, Native &native) {
    const int64_t high = random.in(0, 2) == 0 ? random.in(-1, 1) : word() >> random.in(0, 62);
    const int64_t low = random.in(0, 2) == 0 ? random.in(-1, 1) : word();
    const int bits = random.in(0, 1) == 0 ? 64 : static_cast<int>(random.in(0, 127));
    number = (Number(high) << bits) + low;
    native = static_cast<Native>((static_cast<UInt128>(Int128{high}) << bits) + static_cast<UInt128>(Int128{low}));
  };
  for (int k = 0; k < 20000; ++k) {
    Number a, b;
    Native native_a, native_b;
    next(a, native_a);
    next(b, native_b);
    const auto x = static_cast<UInt128>(native_a), y = static_cast<UInt128>(native_b);
    const int bits = static_cast<int>(random.in(0, 127));
    expect_same(a, native_a);
    expect_same(a + b, static_cast<Native>(x + y));
    expect_same(a - b, static_cast<Native>(x - y));
    expect_same(a * b, static_cast<Native>(x * y));
    expect_same(-a, static_cast<Native>(UInt128{0} - x));
    expect_same(a << bits, static_cast<Native>(x << bits));
    expect_same(a >> bits, native_a >> bits);
    EXPECT_EQ(a < b, native_a < native_b);
    EXPECT_EQ(a >= b, native_a >= native_b);
    EXPECT_EQ(a == b, native_a == native_b);
    const auto rounded = static_cast<double>(native_a);
    EXPECT_NEAR(static_cast<double>(a), rounded, 0x1p-52 * std::fabs(rounded));
    if (std::fabs(rounded) < 0x1p126) expect_same(Number(rounded), static_cast<Native>(rounded));
  }
}

TEST(TwoWords, AreTheCompilersIntegersWithASign) {
  compare_with_native<Signed, Int128>();
}

TEST(TwoWords, AreTheCompilersIntegersWithoutASign) {
  compare_with_native<Unsigned, UInt128>();
}
#endif

}  // namespace
