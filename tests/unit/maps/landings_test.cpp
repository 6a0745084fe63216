#include "maps/map_linker.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace {

using hsp::Landing;
using hsp::landing_tolerance;
using hsp::MapArc;
using hsp::MapVertexKind;
using hsp::pi;

constexpr hsp::ArcEnd bite{MapVertexKind::tangency, 3};

MapArc arc(double from, double to) {
  return {from, to, 2, hsp::no_id, {bite, bite}, false};
}

// Numbers of the landings in their order; they keep their parameters.
std::vector<uint32_t> sorted(const std::vector<MapArc> &contour, std::vector<Landing> &landings) {
  hsp::sort_landings({contour.data(), static_cast<uint32_t>(contour.size())},
                     {landings.data(), static_cast<uint32_t>(landings.size())});
  std::vector<uint32_t> order;
  for (const Landing &landing : landings) order.push_back(landing.vertex);
  return order;
}

TEST(Landings, ComeAtTheTurnOfTheArcs) {
  std::vector<Landing> landings = {{1, 0}, {-3, 1}, {-2, 2}};
  EXPECT_EQ(sorted({arc(-4, -3.5), arc(-3.2, 1.5)}, landings), (std::vector<uint32_t>{1, 2, 0}));
  landings = {{1, 0}, {3, 1}, {-2, 2}};
  EXPECT_EQ(sorted({arc(-4, 1.5)}, landings), (std::vector<uint32_t>{1, 2, 0}));
  EXPECT_DOUBLE_EQ(landings[0].t, 3 - 2 * pi);
}

// Where the contour begins and ends there is a gap like others, however narrow: what lies in it belongs to its nearer
// side, so that not all of it comes first.
TEST(Landings, BelongToTheNearerSideOfTheGapAtTheEnds) {
  for (const double gap : {0x1p-10, landing_tolerance, 0x1p-30}) {
    const double from = 1.25 - 2 * pi + gap;
    std::vector<Landing> landings = {{1.25 + 0.25 * gap, 0}, {1.25 + 0.75 * gap, 1}};
    EXPECT_EQ(sorted({arc(from, 1.25)}, landings), (std::vector<uint32_t>{1, 0})) << gap;
    EXPECT_NEAR(landings[0].t, from - 0.25 * gap, 1e-15);
    EXPECT_NEAR(landings[1].t, 1.25 + 0.25 * gap, 1e-15);
  }
}

TEST(Landings, OnWholeContours) {
  MapArc whole = arc(-pi, pi);
  whole.closed = true;
  std::vector<Landing> landings = {{pi, 0}, {-1, 1}, {2, 2}, {-1, 3}};
  EXPECT_EQ(sorted({whole}, landings), (std::vector<uint32_t>{0, 1, 3, 2}));
  EXPECT_EQ(landings[0].t, -pi);
}

}  // namespace
