// Where a circle passes a plane; what is hidden of a line by intervals of it, one after another.
#include "maps/hidden_parts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "random_balls.hpp"

namespace {

TEST(VisitLevel, AnglesWhereACircleIsAtALevel) {
  oracle::RandomSource random(1);
  for (int turn = 0; turn < 200; ++turn) {
    const double a = 0.01 * static_cast<double>(random.in(-300, 300));
    const double b = 0.01 * static_cast<double>(random.in(-300, 300));
    const double level = 0.01 * static_cast<double>(random.in(-500, 500)) + 0.001;
    std::vector<double> found;
    hsp::visit_level(a, b, level, [&](double t) { found.push_back(t); });
    ASSERT_EQ(found.size(), std::hypot(a, b) > std::fabs(level) ? 2U : 0U);
    for (const double t : found) {
      EXPECT_NEAR(a * std::cos(t) + b * std::sin(t), level, 1e-12);
      EXPECT_LE(std::fabs(t), hsp::pi);
    }
    if (found.size() == 2) {
      EXPECT_GT(std::fabs(found[0] - found[1]), 1e-6);
    }
  }
  hsp::visit_level(3.0, 4.0, 5.0, [](double) { FAIL() << "it only touches"; });
}

// A line that is hidden by some depth between two parameters.
class Line : public hsp::HiddenParts {
 public:
  using HiddenParts::HiddenParts;
  using HiddenParts::narrow;
  bool hide(double from, double to, double deep = 1.0) {
    begin_body();
    add(from, {hsp::MapVertexKind::t, 7});
    add(to, {hsp::MapVertexKind::t, 7});
    return cut(0.5, [&](double a, double b) { return 0.5 * (a + b) > from && 0.5 * (a + b) < to ? deep : -deep; });
  }
  double from() const { return from_; }
  double to() const { return to_; }
};

TEST(HiddenParts, HiddenAtBothEndsAndInTheMiddle) {
  std::vector<hsp::HiddenInterval> room(8);
  hsp::FixedVector<hsp::HiddenInterval> hidden(hsp::Span<hsp::HiddenInterval>(room.data(), 8));
  Line line(-3.0, 3.0, hidden);
  EXPECT_FALSE(line.hide(0.0, 1.0));
  EXPECT_FALSE(line.narrow());
  ASSERT_EQ(hidden.size(), 1U);
  EXPECT_EQ(hidden[0].from, 0.0);
  EXPECT_EQ(hidden[0].to, 1.0);
  EXPECT_EQ(hidden[0].end[0].body, 7U);
  EXPECT_FALSE(line.hide(-9.0, -2.0));
  EXPECT_TRUE(line.narrow());
  EXPECT_FALSE(line.hide(2.0, 9.0));
  EXPECT_TRUE(line.narrow());
  EXPECT_EQ(line.from(), -2.0);
  EXPECT_EQ(line.to(), 2.0);
  EXPECT_EQ(hidden.size(), 3U);
  EXPECT_EQ(hidden[1].end[0].kind, hsp::MapVertexKind::plain);
  EXPECT_TRUE(line.certain());
  // The rest is hidden as a whole, and that is no part.
  EXPECT_TRUE(line.hide(-2.5, 2.5));
  EXPECT_EQ(hidden.size(), 3U);
}

TEST(HiddenParts, ShallowPartsAreNotCertain) {
  std::vector<hsp::HiddenInterval> room(2);
  hsp::FixedVector<hsp::HiddenInterval> hidden(hsp::Span<hsp::HiddenInterval>(room.data(), 2));
  Line line(0.0, 1.0, hidden);
  EXPECT_FALSE(line.hide(0.25, 0.5, 0.75));
  EXPECT_TRUE(line.certain());
  EXPECT_FALSE(line.hide(0.25, 0.5, 0.25));
  EXPECT_FALSE(line.certain());
}

}  // namespace
