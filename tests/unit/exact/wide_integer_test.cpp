// Fixed-width integers: the ring axioms that determine them, agreement of both limb widths, and conversion to double.
#include "exact/wide_integer.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "random_balls.hpp"

namespace {

using hsp::exact::product;
using hsp::exact::WideInteger;

oracle::RandomSource random_source(3);

// Values near powers of two and small ones as often as anything else.
int64_t random_value() {
  const uint64_t bits = random_source.next();
  const int shift = static_cast<int>(bits % 63);
  const int64_t value = static_cast<int64_t>(random_source.next()) >> shift;
  switch (bits >> 60) {
    case 0:
      return (int64_t{1} << shift) - 1;
    case 1:
      return -(int64_t{1} << shift);
    case 2:
      return static_cast<int64_t>(bits % 3) - 1;
    default:
      return value;
  }
}

template <class Limb>
class WideIntegers : public testing::Test {};
#if defined(__SIZEOF_INT128__)
using Limbs = testing::Types<uint32_t, uint64_t>;
#else
using Limbs = testing::Types<uint32_t>;
#endif
TYPED_TEST_SUITE(WideIntegers, Limbs);

TYPED_TEST(WideIntegers, ProductsOfSumsDistribute) {
  using I64 = WideInteger<TypeParam, 64>;
  using I256 = WideInteger<TypeParam, 256>;
  for (int k = 0; k < 20000; ++k) {
    // (a + b)(c d) e = a c d e + b c d e with 63-bit factors: up to 253 bits.
    const int64_t a = random_value() / 2, b = random_value() / 2, c = random_value(), d = random_value(),
                  e = random_value();
    const auto cd = product<128>(I64::from(c), I64::from(d));
    const auto cde = product<192>(cd, I64::from(e));
    const I256 left = product<256>(I64::from(a + b), cde);
    const I256 right = product<256>(I64::from(a), cde) + product<256>(cde, I64::from(b));
    EXPECT_EQ((left - right).sign(), 0);
    const int expected = (a + b == 0 || c == 0 || d == 0 || e == 0)         ? 0
                         : ((a + b < 0) != (c < 0)) != ((d < 0) != (e < 0)) ? -1
                                                                            : 1;
    EXPECT_EQ(left.sign(), expected);
    EXPECT_EQ((-left).sign(), -expected);
  }
}

TYPED_TEST(WideIntegers, DoublesAreTheNearest) {
  using I64 = WideInteger<TypeParam, 64>;
  using I192 = WideInteger<TypeParam, 192>;
  for (int k = 0; k < 20000; ++k) {
    const int64_t a = random_value();
    EXPECT_EQ(I64::from(a).to_double(), static_cast<double>(a)) << a;
    // a 2^100 + b: far beyond 64 bits, the low part decides the last bit. The neighbours must not be closer.
    const int64_t b = random_value();
    const auto shifted =
        product<192>(product<128>(I64::from(a), I64::from(int64_t{1} << 50)), I64::from(int64_t{1} << 50));
    const I192 value = shifted + I192::from(b);
    const double rounded = value.to_double();
    const auto distance = [&value](double x) {
      // |value - x| for a double x that is an integer with at most 53 significant bits.
      int exponent = 0;
      const int64_t mantissa = static_cast<int64_t>(std::frexp(x, &exponent) * 0x1p53);
      exponent -= 53;
      I192 integer = I192::from(mantissa);
      for (; exponent > 0; --exponent) integer = integer + integer;
      if (exponent < 0) integer = I192::from(static_cast<int64_t>(x));
      const I192 difference = value - integer;
      return difference.negative() ? -difference : difference;
    };
    for (const double neighbour : {std::nextafter(rounded, INFINITY), std::nextafter(rounded, -INFINITY)}) {
      if (std::fabs(neighbour) < 0x1p53) continue;
      EXPECT_LE((distance(rounded) - distance(neighbour)).sign(), 0) << a << " " << b;
    }
  }
}

#if defined(__SIZEOF_INT128__)
TEST(WideInteger, LimbWidthsAgree) {
  for (int k = 0; k < 20000; ++k) {
    const int64_t v[4] = {random_value(), random_value(), random_value(), random_value()};
    const auto evaluate = [&v]<class Limb>(Limb) {
      using I64 = WideInteger<Limb, 64>;
      const auto ab = product<128>(I64::from(v[0]), I64::from(v[1]));
      const auto cd = product<128>(I64::from(v[2]), I64::from(v[3]));
      return product<256>(ab, cd) - product<256>(cd, cd);
    };
    const auto narrow = evaluate(uint32_t{});
    const auto wide = evaluate(uint64_t{});
    for (int limb = 0; limb < 4; ++limb) {
      EXPECT_EQ(wide.limb[limb], static_cast<uint64_t>(narrow.limb[2 * limb + 1]) << 32 | narrow.limb[2 * limb]);
    }
    EXPECT_EQ(narrow.to_double(), wide.to_double());
  }
}
#endif

}  // namespace
