// The stops of the headlight against the light that they approximate.
#include "picture/shading.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

// The headlight's stops before they are rounded to colours: linear in between, within .0034 of the light's range.
TEST(Shades, OfTheHeadlightAreWhereTheyServeBest) {
  const hsp::Shading shading(false);
  const auto light = [&](uint32_t stop) { return shading.lit({{255, 255, 255}}, stop).channel[1]; };
  const double rim = light(shading.intervals());
  const double rise = light(0) - rim;
  double worst = 0;
  for (uint32_t k = 0; k < shading.intervals(); ++k) {
    for (int i = 0; i <= 100; ++i) {
      const double share = i / 100.0;
      const double rho = shading.offset(k) + (shading.offset(k + 1) - shading.offset(k)) * share;
      const double drawn = light(k) + (light(k + 1) - light(k)) * share;
      worst = std::fmax(worst, std::fabs((drawn - rim) / rise - std::sqrt(1 - rho * rho)));
    }
  }
  EXPECT_LE(worst, 0.0034);
}

}  // namespace
