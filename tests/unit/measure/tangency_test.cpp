// Which balls that lie in another one touch it from inside, in a point that no third ball covers.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "built_boundary.hpp"
#include "measure/tangency.hpp"

namespace {

// Whether ball 0 of the set touches ball 1 freely from inside.
bool touches(const oracle::Balls &set) {
  BuiltBoundary built(set);
  EXPECT_EQ(built.status(), hsp::Status::ok);
  hsp::CubeBlock all;
  all.ranges = 1;
  all.range[0] = {0, built.balls().n};
  return hsp::touches_freely_from_inside(built.balls(), all, built.grid_index(0), built.grid_index(1));
}

TEST(InnerTouching, TwoBalls) {
  EXPECT_TRUE(touches({{3, 0, 0, 2}, {0, 0, 0, 5}}));
  EXPECT_TRUE(touches({{2, 1, 2, 2}, {0, 0, 0, 5}}));
  EXPECT_FALSE(touches({{2, 1, 1, 2}, {0, 0, 0, 5}}));  // inside, 0.55 away
  EXPECT_FALSE(touches({{2, 2, 2, 2}, {0, 0, 0, 5}}));  // pokes out
  EXPECT_FALSE(touches({{0, 0, 0, 2}, {0, 0, 0, 5}}));  // concentric
  EXPECT_FALSE(touches({{3, 0, 0, 5}, {0, 0, 0, 2}}));  // the other way round
  EXPECT_FALSE(touches({{7, 0, 0, 2}, {0, 0, 0, 5}}));  // from outside
  EXPECT_TRUE(touches({{5, 0, 0, 0}, {0, 0, 0, 5}}));   // a point on the sphere
  EXPECT_TRUE(touches({{1, 2, 3, 4}, {1, 2, 3, 4}}));   // equal
}

// The point of touching is (5, 0, 0).
TEST(InnerTouching, AThirdBallAtThePoint) {
  const oracle::LatticeBall inner{3, 0, 0, 2};
  const oracle::LatticeBall outer{0, 0, 0, 5};
  EXPECT_FALSE(touches({inner, outer, {6, 0, 0, 2}}));  // covers it
  EXPECT_TRUE(touches({inner, outer, {6, 0, 0, 1}}));   // its sphere goes through it
  EXPECT_TRUE(touches({inner, outer, {7, 0, 0, 1}}));
  EXPECT_TRUE(touches({inner, outer, {1, 0, 0, 4}}));  // a second one that touches there
  EXPECT_TRUE(touches({inner, outer, {5, 3, 4, 5}}));
  EXPECT_FALSE(touches({inner, outer, {5, 3, 3, 5}}));
  EXPECT_FALSE(touches({inner, outer, {1, 0, 0, 5}}));
}

// The largest balls of the lattice: the point has a denominator of nearly 2^30.
TEST(InnerTouching, LargestNumbers) {
  constexpr int64_t most = (int64_t{1} << 30) - 1;
  constexpr int64_t D = most - 1;  // 2^30 - 2
  const oracle::LatticeBall inner{D, 0, 0, 1};
  const oracle::LatticeBall outer{0, 0, 0, most};
  EXPECT_TRUE(touches({inner, outer}));
  EXPECT_TRUE(touches({inner, outer, {2 * most, 0, 0, most}}));
  EXPECT_FALSE(touches({inner, outer, {2 * most - 1, 0, 0, most}}));
  // (2, -1, 2)/3 of the radius, which is a multiple of 3.
  const oracle::LatticeBall tilted{2 * (most - 3) / 3, -(most - 3) / 3, 2 * (most - 3) / 3, 3};
  EXPECT_TRUE(touches({tilted, outer}));
  const oracle::LatticeBall facing{4 * most / 3, -2 * most / 3, 4 * most / 3, most};
  EXPECT_TRUE(touches({tilted, outer, facing}));
  EXPECT_FALSE(touches({tilted, outer, {facing.x - 1, facing.y, facing.z, most}}));
  EXPECT_TRUE(touches({tilted, outer, {facing.x + 1, facing.y, facing.z, most}}));
}

// The pairs (inner, outer) by the caller's indices.
std::vector<std::pair<uint32_t, uint32_t>> contacts(const oracle::Balls &set) {
  BuiltBoundary built(set);
  EXPECT_EQ(built.status(), hsp::Status::ok);
  std::vector<std::pair<uint32_t, uint32_t>> found;
  hsp::visit_free_inner_contacts(built.grid(), built.boundary(), [&](uint32_t i, uint32_t j) {
    found.emplace_back(built.balls().caller[i], built.balls().caller[j]);
  });
  std::sort(found.begin(), found.end());
  return found;
}

TEST(FreeInnerContacts, OfBallsInsideOthers) {
  using Pairs = std::vector<std::pair<uint32_t, uint32_t>>;
  EXPECT_EQ(contacts({{3, 0, 0, 2}, {0, 0, 0, 5}, {-1, 0, 0, 2}}), (Pairs{{0, 1}}));
  EXPECT_EQ(contacts({{7, 0, 0, 2}, {0, 0, 0, 5}}), Pairs{});
  // Of equal balls the one with the face is the outer one of all others.
  EXPECT_EQ(contacts({{0, 0, 0, 5}, {0, 0, 0, 5}, {0, 0, 0, 5}}).size(), 2U);
  // None of them has a face: nothing is bared.
  EXPECT_EQ(contacts({{0, 0, 0, 5}, {0, 0, 0, 5}, {0, 0, 0, 9}}), Pairs{});
}

}  // namespace
