// Limits of views.
#include "view/view.hpp"

#include <gtest/gtest.h>

namespace {

TEST(ViewLimits, DefaultsForANumberOfBalls) {
  hsp::ViewLimits limits;
  EXPECT_EQ(hsp::default_limits(300, limits), hsp::Status::ok);
  EXPECT_EQ(limits.balls, 300U);
  EXPECT_EQ(limits.neighbours, 256U);
  EXPECT_EQ(limits.arcs, 3664U);
  constexpr uint32_t most = (hsp::max_count - 64) / 12;
  EXPECT_EQ(hsp::default_limits(most, limits), hsp::Status::ok);
  EXPECT_LE(limits.arcs, hsp::max_count);
  EXPECT_EQ(hsp::default_limits(most + 1, limits), hsp::Status::range);
}

}  // namespace
