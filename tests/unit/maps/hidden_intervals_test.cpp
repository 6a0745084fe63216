#include "maps/hidden_intervals.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace {

using hsp::ArcEnd;
using hsp::HiddenInterval;
using hsp::MapArc;
using hsp::MapVertexKind;
using hsp::pi;

constexpr ArcEnd natural{MapVertexKind::tangency, hsp::no_id};

ArcEnd by(uint32_t ball) {
  return {MapVertexKind::t, ball};
}
HiddenInterval hidden(double from, double to, uint32_t ball) {
  return {from, to, {by(ball), by(ball)}};
}

std::vector<MapArc> visible(std::vector<HiddenInterval> intervals, double from, double to, const ArcEnd &end) {
  std::vector<MapArc> memory(10);
  hsp::FixedVector<MapArc> arcs(hsp::Span<MapArc>(memory.data(), 10));
  hsp::push_visible({intervals.data(), static_cast<uint32_t>(intervals.size())}, from, to, end, 3, 4, arcs);
  return {arcs.items().begin(), arcs.items().end()};
}

TEST(HiddenIntervals, LeaveArcsBetweenThem) {
  const auto arcs =
      visible({hidden(1, 2, 7), hidden(-1, 0, 8), hidden(1.5, 2.5, 9), hidden(1.2, 1.3, 6)}, -2, 3, natural);
  ASSERT_EQ(arcs.size(), 3U);
  EXPECT_EQ(arcs[0].from, -2.0);
  EXPECT_EQ(arcs[0].to, -1.0);
  EXPECT_EQ(arcs[0].end[0].kind, MapVertexKind::tangency);
  EXPECT_EQ(arcs[0].end[1].body, 8U);
  EXPECT_EQ(arcs[1].from, 0.0);
  EXPECT_EQ(arcs[1].to, 1.0);
  EXPECT_EQ(arcs[1].end[0].body, 8U);
  EXPECT_EQ(arcs[1].end[1].body, 7U);
  EXPECT_EQ(arcs[2].from, 2.5);
  EXPECT_EQ(arcs[2].end[0].body, 9U);
  EXPECT_EQ(arcs[2].end[1].kind, MapVertexKind::tangency);
  EXPECT_EQ(arcs[2].body, 3U);
  EXPECT_EQ(arcs[2].nearer, 4U);
}

TEST(HiddenIntervals, OfAClosedCurveLeaveOneArcAcrossItsSeam) {
  const auto arcs = visible({hidden(-1, 0, 8), hidden(1, 2, 7)}, -pi, pi, {});
  ASSERT_EQ(arcs.size(), 2U);
  EXPECT_EQ(arcs[0].from, 2 - 2 * pi);
  EXPECT_EQ(arcs[0].to, -1.0);
  EXPECT_EQ(arcs[0].end[0].body, 7U);
  EXPECT_EQ(arcs[0].end[1].body, 8U);
  EXPECT_EQ(arcs[1].from, 0.0);
  EXPECT_FALSE(arcs[0].closed || arcs[1].closed);
}

TEST(HiddenIntervals, MayEndAtTheSeam) {
  // Hidden from 3 across the seam to -3.
  const auto arcs = visible({{3, pi, {by(5), {}}}, {-pi, -3, {{}, by(5)}}, hidden(0, 1, 6)}, -pi, pi, {});
  ASSERT_EQ(arcs.size(), 2U);
  EXPECT_EQ(arcs[0].from, -3.0);
  EXPECT_EQ(arcs[0].end[0].body, 5U);
  EXPECT_EQ(arcs[1].to, 3.0);
  EXPECT_EQ(arcs[1].end[1].body, 5U);
}

TEST(HiddenIntervals, LeaveAllOrNothing) {
  auto arcs = visible({}, -pi, pi, {});
  ASSERT_EQ(arcs.size(), 1U);
  EXPECT_TRUE(arcs[0].closed);
  arcs = visible({}, -1, 1, natural);
  ASSERT_EQ(arcs.size(), 1U);
  EXPECT_FALSE(arcs[0].closed);
  EXPECT_TRUE(visible({hidden(-2, 0.5, 1), hidden(0.25, 2, 2)}, -1, 1, natural).empty());
}

TEST(HiddenIntervals, AreCountedWithoutRoom) {
  std::vector<HiddenInterval> intervals = {hidden(-1, 0, 8), hidden(1, 2, 7)};
  hsp::FixedVector<MapArc> arcs;
  hsp::push_visible({intervals.data(), 2}, -pi, pi, {}, 3, 4, arcs);
  EXPECT_EQ(arcs.required(), 2U);
}

// Where one ball ceases to hide a curve another one begins to: something may be seen there, but for roundings.
TEST(HiddenIntervals, TellWhereNothingIsSeenForRoundings) {
  const auto certain = [](std::vector<HiddenInterval> intervals) {
    std::vector<MapArc> memory(10);
    hsp::FixedVector<MapArc> arcs(hsp::Span<MapArc>(memory.data(), 10));
    return hsp::push_visible({intervals.data(), static_cast<uint32_t>(intervals.size())}, -pi, pi, {}, 3, hsp::no_id,
                             arcs);
  };
  EXPECT_TRUE(certain({}));
  EXPECT_TRUE(certain({hidden(-1, 1, 7), hidden(1.001, 2, 8)}));
  EXPECT_TRUE(certain({hidden(-1, 1, 7), hidden(0.999, 2, 8)}));
  EXPECT_FALSE(certain({hidden(-1, 1, 7), hidden(1, 2, 8)}));
  EXPECT_FALSE(certain({hidden(-1, 1, 7), hidden(1 - 1e-9, 2, 8)}));
  EXPECT_TRUE(certain({hidden(-1, 1, 7), hidden(1, 2, 8), hidden(0.5, 1.5, 9)}));
  // Where angles begin there is no end of what one ball hides on both sides.
  EXPECT_TRUE(certain({{-pi, -3, {{}, by(7)}}, {3, pi, {by(7), {}}}}));
  EXPECT_FALSE(certain({hidden(-pi, -3, 7)}));
}

}  // namespace
