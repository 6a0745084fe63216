#include "maps/ball_scene.hpp"

#include <gtest/gtest.h>

namespace {

using hsp::MapLimits;
using hsp::Status;

TEST(VisibilityMap, HasDefaultLimits) {
  MapLimits limits;
  ASSERT_EQ(hsp::default_limits(0, limits), Status::ok);
  EXPECT_EQ(limits.edges, 64U);
  ASSERT_EQ(hsp::default_limits(300, limits), Status::ok);
  EXPECT_EQ(limits.balls, 300U);
  EXPECT_EQ(limits.neighbours, 256U);
  EXPECT_EQ(limits.edges, 3664U);
  const uint32_t most = (hsp::max_count - 64) / 12;
  ASSERT_EQ(hsp::default_limits(most, limits), Status::ok);
  EXPECT_LE(limits.edges, hsp::max_count);
  EXPECT_EQ(hsp::default_limits(most + 1, limits), Status::range);
  EXPECT_EQ(hsp::default_limits(0xFFFFFFFF, limits), Status::range);
}

TEST(VisibilityMap, LimitsCoverEachOther) {
  const MapLimits both = covering(MapLimits{1, 20, 3}, {10, 2, 30});
  EXPECT_EQ(both.balls, 10U);
  EXPECT_EQ(both.neighbours, 20U);
  EXPECT_EQ(both.edges, 30U);
}

}  // namespace
