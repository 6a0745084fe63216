// The quadratic form of the last amount against one of 128 bits, up to the largest vectors, with both limb widths.
#include "exact/power.hpp"

#include <gtest/gtest.h>

#include "big_integer.hpp"
#include "random_balls.hpp"

namespace {

using hsp::exact::Vector;
using oracle::Int128;

template <class Limb>
void expect_form(const Vector &v, const Int128 &expected) {
  const auto amount = hsp::exact::last_amount<Limb>(v);
  for (int k = 0; k < amount.limbs; ++k) {
    EXPECT_EQ(amount.limb[k], static_cast<Limb>(expected >> (k * amount.limb_bits))) << v.x << ' ' << v.y << ' ' << v.z;
  }
}

TEST(LastAmount, IsTheQuadraticForm) {
  oracle::RandomSource random(608);
  for (const int64_t most : {int64_t{3}, int64_t{100000}, (int64_t{1} << 31) - 1}) {
    for (int k = 0; k < 300; ++k) {
      const auto part = [&] { return random.one_in(4) ? (random.one_in(2) ? most : -most) : random.in(-most, most); };
      const int64_t a = part(), b = part(), c = part();
      const Int128 x = a, y = b, z = c;
      const Int128 form = 1009 * x * x + 757 * x * y + 499 * x * z + 331 * y * y + 211 * y * z + 113 * z * z;
      expect_form<uint32_t>({a, b, c}, form);
      expect_form<hsp::exact::FastLimb>({a, b, c}, form);
    }
  }
}

}  // namespace
