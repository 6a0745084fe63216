// Sums of areas as integers, against integers of the compiler's and long doubles.
#include "bricks/exact_sums.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "int128.hpp"
#include "random_numbers.hpp"

namespace {

oracle::Int128 value_of(const hsp::AreaSum &sum) {
  oracle::Int128 value = 0;
  for (int k = hsp::AreaSum::limbs - 1; k >= 0; --k) {
    for (int bits = 0; bits < hsp::AreaSum::limb_bits; bits += 16) value = value * 65536;
    value = value +
            static_cast<int64_t>(sum.limb[k] >> 32 % hsp::AreaSum::limb_bits) * (INT64_C(1) << 32) *
                (hsp::AreaSum::limb_bits > 32 ? 1 : 0) +
            static_cast<int64_t>(sum.limb[k] & 0xFFFFFFFF);
  }
  return value;
}

// Below 2^62 to nearest, above it exactly.
TEST(ExactSums, RoundsToTheQuantumOnce) {
  support::Random random(3);
  for (int64_t radius : {INT64_C(0), INT64_C(1), INT64_C(7), INT64_C(8), INT64_C(1) << 29, (INT64_C(1) << 30) - 1}) {
    const hsp::AreaQuantum quantum(radius);
    int e = 0;
    while (radius >> e != 0) ++e;
    for (int k = 0; k < 2000; ++k) {
      const double size = std::ldexp(random.fraction() - 0.5, 4 + 2 * e - static_cast<int>(random.below(120)));
      const long double quanta = std::ldexp(static_cast<long double>(size), 80 - 2 * e);
      const hsp::AreaSum sum = quantum.round(size);
      if (std::fabs(quanta) < 0x1p62L) {
        ASSERT_EQ(sum.to_double(), static_cast<double>(static_cast<int64_t>(std::round(quanta)))) << size;
      } else {
        ASSERT_EQ(sum.to_double(), static_cast<double>(quanta)) << size;
        ASSERT_EQ(quantum.area(sum), size);
      }
    }
  }
}

TEST(ExactSums, AddUpInAnyOrder) {
  support::Random random(4);
  const hsp::AreaQuantum quantum(1000);
  std::vector<double> areas;
  for (int k = 0; k < 5000; ++k)
    areas.push_back(std::ldexp(random.fraction() - 0.2, static_cast<int>(random.below(24))));
  hsp::AreaSum forwards{}, backwards{};
  long double expected = 0;
  for (size_t k = 0; k < areas.size(); ++k) {
    forwards = forwards + quantum.round(areas[k]);
    backwards = backwards + quantum.round(areas[areas.size() - 1 - k]);
    expected += areas[k];
  }
  EXPECT_EQ((forwards - backwards).sign(), 0);
  EXPECT_EQ(value_of(forwards) == value_of(backwards), true);
  EXPECT_NEAR(quantum.area(forwards), static_cast<double>(expected), 1e-12 * static_cast<double>(expected));
}

// (a b) c = a (b c), of numbers that fill the bits that areas and coordinates have.
TEST(ExactSums, TimesALength) {
  support::Random random(5);
  for (int k = 0; k < 5000; ++k) {
    const int64_t a = random.in(INT64_MIN / 2, INT64_MAX / 2), b = random.in(-(INT64_C(1) << 31), INT64_C(1) << 31);
    const int64_t length = random.in(-(INT64_C(1) << 52), INT64_C(1) << 52);
    using Factor = hsp::exact::WideInteger<hsp::exact::FastLimb, 64>;
    const hsp::AreaSum area = hsp::exact::product<128>(Factor::from(a), Factor::from(b));
    const hsp::VolumeSum volume = hsp::times(area, length);
    const long double expected =
        static_cast<long double>(a) * static_cast<long double>(b) * static_cast<long double>(length);
    ASSERT_NEAR(volume.to_double() / static_cast<double>(expected), 1.0, 1e-15);
    // Exactly, modulo 2^64.
    uint64_t low = static_cast<uint64_t>(a) * static_cast<uint64_t>(b) * static_cast<uint64_t>(length);
    if constexpr (hsp::VolumeSum::limb_bits == 64)
      ASSERT_EQ(volume.limb[0], low);
    else
      ASSERT_EQ(volume.limb[0], static_cast<uint32_t>(low));
  }
}

TEST(ExactSums, VolumesAreAThird) {
  const hsp::AreaQuantum quantum(5);
  const hsp::AreaSum area = quantum.round(90.0);
  EXPECT_EQ(quantum.volume(hsp::times(area, 7)), 210.0);
  EXPECT_EQ(quantum.volume(hsp::times(area, -7)), -210.0);
}

}  // namespace
