// Rounding to the decimal lattice: what is written with few decimals is represented exactly.
#include "exact/lattice.hpp"

#include <gtest/gtest.h>

#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <random>

namespace {

using hsp::nearest;
using hsp::exact::Lattice;

TEST(Lattice, DecimalTextIsExactUpToTheLimit) {
  std::mt19937_64 random(9);
  for (int digits = 0; digits <= 12; ++digits) {
    double step = 1.0;
    for (int k = 0; k < digits; ++k) step *= 10;
    const Lattice lattice = Lattice::with_step(1.0 / step);
    EXPECT_EQ(lattice.step(), 1.0 / step);
    for (int k = 0; k < 20000; ++k) {
      const int64_t steps = static_cast<int64_t>(random() % (uint64_t{1} << 51)) - (int64_t{1} << 50);
      const int64_t absolute = steps < 0 ? -steps : steps;
      const int64_t unit = static_cast<int64_t>(step);
      char text[64];
      std::snprintf(text, sizeof text, "%s%" PRId64 ".%0*" PRId64, steps < 0 ? "-" : "", absolute / unit,
                    digits == 0 ? 1 : digits, absolute % unit);
      EXPECT_EQ(nearest(lattice.steps(std::strtod(text, nullptr))), steps) << text << " digits " << digits;
    }
  }
}

TEST(Lattice, DefaultStepIsTheSmallestPowerOfTenThatHoldsTheLargestRadius) {
  const auto step_for = [](double radius) {
    Lattice lattice;
    EXPECT_TRUE(Lattice::for_largest_radius(radius, 0.0, lattice)) << radius;
    return lattice.step();
  };
  EXPECT_EQ(step_for(1.8), 1e-8);
  EXPECT_EQ(step_for(3.2), 1e-8);
  EXPECT_EQ(step_for(10.7), 1e-8);
  EXPECT_EQ(step_for(10.8), 1e-7);
  EXPECT_EQ(step_for(1.07), 1e-9);
  EXPECT_EQ(step_for(0.0), 1e-8);
  EXPECT_EQ(step_for(1.073741823), 1e-9);
  EXPECT_EQ(step_for(1.073741824), 1e-8);
  EXPECT_EQ(step_for(1.8e6), 1e-2);
  EXPECT_EQ(step_for(1.8e-6), 1e-14);
  EXPECT_EQ(step_for(1e-300), 1e-22);
  EXPECT_EQ(step_for(1e30), 1e22 / 10);
  Lattice lattice;
  // Radius and probe are rounded on their own: here each rounds up, and the sum would be 2^30.
  EXPECT_TRUE(Lattice::for_largest_radius(0.5368709115, 0.5368709115, lattice));
  EXPECT_EQ(lattice.step(), 1e-8);
  EXPECT_FALSE(Lattice::for_largest_radius(1e300, 0.0, lattice));
}

TEST(Lattice, HalvesRoundAwayFromZero) {
  EXPECT_EQ(nearest(0.5), 1);
  EXPECT_EQ(nearest(-0.5), -1);
  EXPECT_EQ(nearest(0.49999999999999994), 0);
  EXPECT_EQ(nearest(2.5), 3);
  EXPECT_EQ(nearest(-2.4), -2);
  EXPECT_EQ(nearest(0x1p52 + 1), (int64_t{1} << 52) + 1);
}

TEST(Lattice, AnyOtherStepWorksToo) {
  const Lattice lattice = Lattice::with_step(0.25);
  EXPECT_EQ(lattice.steps(1.0), 4.0);
  EXPECT_EQ(lattice.length(4.0), 1.0);
  EXPECT_EQ(lattice.area(16.0), 1.0);
  EXPECT_EQ(lattice.volume(64.0), 1.0);
}

}  // namespace
