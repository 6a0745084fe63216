// Volumes beside surfaces in a periodic box, up to whole boxes: all of free space against the shares of the balls, for
// any ball as the origin; and what stands for a sum.
#include "periodic/surface_volume.hpp"

#include <gtest/gtest.h>

#include "weighted_box.hpp"

namespace {

TEST(SurfaceVolume, IsThatOfTheSharesUpToBoxes) {
  oracle::RandomSource random(77);
  int crossing = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const WeightedBox set(random, 3 + trial % 9);
    const BuiltPeriodic built = set.built();
    ASSERT_EQ(built.status(), hsp::Status::ok);
    const hsp::Boundary &boundary = built->boundary();
    if (boundary.face_count() == 0) continue;
    const hsp::SurfaceVolume surface(built.get());
    double filled = 0.0, area = 0.0;
    for (uint32_t i = 0; i < built.balls(); ++i) {
      filled += hsp::measure_in_box(built.get(), i).volume;
      area += hsp::measure_in_box(built.get(), i).area;
    }
    const double box = surface.box_volume(), free = box - filled;
    for (uint32_t origin = 0; origin < built.balls(); ++origin) {
      double sum = 0.0, areas = 0.0;
      for (uint32_t face = 0; face < boundary.face_count(); ++face) {
        const hsp::BallMeasure term = surface.measure(face, origin);
        sum += term.volume;
        areas += term.area;
      }
      ASSERT_NEAR(surface.reduced(sum, free) / box, free / box, 1e-12);
      ASSERT_NEAR(areas / area, 1.0, 1e-12);
      crossing += std::fabs(sum - free) > 0.5 * box ? 1 : 0;
    }
  }
  EXPECT_GT(crossing, 100);
}

TEST(SurfaceVolume, ASumStandsForOneVolume) {
  const WeightedBox set = [] {
    oracle::RandomSource random(5);
    return WeightedBox(random, 4);
  }();
  const BuiltPeriodic built = set.built();
  const hsp::SurfaceVolume surface(built.get());
  const double box = surface.box_volume();
  for (const double most : {1e-9 * box, 0.3 * box, (1.0 - 1e-9) * box}) {
    for (const double volume : {1e-6 * most, 0.5 * most, most}) {
      for (const double boxes : {-3.0, -1.0, 0.0, 2.0}) {
        EXPECT_NEAR(surface.reduced(volume + boxes * box, most) / box, volume / box, 1e-15 * (1.0 + std::fabs(boxes)));
      }
    }
    EXPECT_EQ(surface.reduced(-1e-14 * box, most), 0.0);  // up to rounding
  }
  EXPECT_NEAR(surface.reduced(0.0, box) / box, 1.0, 1e-15);  // where nothing is filled
}

}  // namespace
