// The painter of elliptical arcs against the equation of the ellipse and against known areas and winding numbers.
#include "path_painter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace oracle;

constexpr double pi = std::numbers::pi;

// A closed loop of arcs of one ellipse, cut at the given parameters, counter-clockwise or clockwise.
Path loop(PathArc ellipse, std::vector<double> cuts, bool counter_clockwise = true) {
  cuts.push_back(cuts.front() + 2 * pi);
  Path path;
  for (size_t k = 0; k + 1 < cuts.size(); ++k) {
    ellipse.from = cuts[k];
    ellipse.to = cuts[k + 1];
    ellipse.start = k == 0 ? ellipse.at(cuts[k]) : path.back().end;
    ellipse.end = k + 2 == cuts.size() ? path.empty() ? ellipse.start : path.front().start : ellipse.at(cuts[k + 1]);
    path.push_back(ellipse);
  }
  if (counter_clockwise) return path;
  Path reversed;
  for (auto arc = path.rbegin(); arc != path.rend(); ++arc) {
    std::swap(arc->from, arc->to);
    std::swap(arc->start, arc->end);
    reversed.push_back(*arc);
  }
  return reversed;
}

PathArc ellipse(double x, double y, double a, double b, double rotation) {
  return {{x, y}, {a, b}, rotation, 0, 0, {}, {}};
}

double area_of(const Path &path) {
  double area = 0;
  for (const PathArc &arc : path) area += arc.swept_area();
  return area;
}

TEST(PathPainter, PaintsEllipsesWhereTheirEquationHolds) {
  const PixelGrid grid{-10, -10, 0.1003, 200, 200};
  for (const double rotation : {0.0, 0.3, -1.2, 2.9, pi, pi / 2})
    for (const std::vector<double> &cuts : {std::vector<double>{0.0}, {-3.0, -1.0, 2.0}, {1.0, 1.001, 1.5, 6.0}}) {
      const PathArc shape = ellipse(1, -2, 7, 3, rotation);
      const Path path = loop(shape, cuts);
      const PaintedImage image = painted({path}, grid);
      EXPECT_TRUE(image.windings.empty());
      EXPECT_EQ(image.even_odd, image.non_zero);
      EXPECT_NEAR(area_of(path), 21 * pi, 1e-12);
      EXPECT_NEAR(area_of(loop(shape, cuts, false)), -21 * pi, 1e-12);
      for (size_t k = 0; k < grid.pixels(); ++k) {
        const double x = grid.x(k % grid.columns) - 1;
        const double y = grid.y(k / grid.columns) + 2;
        const double u = (x * std::cos(rotation) + y * std::sin(rotation)) / 7;
        const double v = (y * std::cos(rotation) - x * std::sin(rotation)) / 3;
        ASSERT_EQ(image.even_odd[k] == 0, u * u + v * v < 1) << "rotation " << rotation;
      }
    }
}

TEST(PathPainter, LeavesHolesAndTellsTheRulesApart) {
  const PixelGrid grid{-10, -10, 0.1003, 200, 200};
  const Path outer = loop(ellipse(0, 0, 8, 8, 0), {0, 2});
  const auto joined = [&](const Path &inner) {
    Path path = outer;
    path.insert(path.end(), inner.begin(), inner.end());
    return path;
  };
  const PathArc hole = ellipse(1, 1, 4, 2, 0.5);
  const Path ring = joined(loop(hole, {1}, false));
  EXPECT_NEAR(area_of(ring), 56 * pi, 1e-12);
  const PaintedImage proper = painted({ring}, grid);
  EXPECT_TRUE(proper.windings.empty());
  EXPECT_EQ(proper.even_odd, proper.non_zero);
  EXPECT_EQ(winding_number(ring, 1, 1), 0);
  EXPECT_EQ(winding_number(ring, -6, 0), 1);
  EXPECT_EQ(winding_number(ring, 9, 0), 0);

  const PaintedImage doubled = painted({joined(loop(hole, {1}))}, grid);  // the hole the wrong way round
  size_t differ = 0;
  for (size_t k = 0; k < grid.pixels(); ++k) differ += doubled.even_odd[k] != doubled.non_zero[k] ? 1 : 0;
  EXPECT_NEAR(static_cast<double>(differ) * grid.side * grid.side, 8 * pi, 0.3);
  ASSERT_EQ(doubled.windings.size(), differ);
  EXPECT_EQ(doubled.windings[0].times, 2);

  const PaintedImage covered = painted({outer, loop(hole, {0})}, grid);  // the later path on top
  for (size_t k = 0; k < grid.pixels(); ++k)
    EXPECT_EQ(covered.even_odd[k] == 1, doubled.windings.size() > 0 && doubled.even_odd[k] != doubled.non_zero[k]);
}

TEST(PathPainter, ReportsPathsThatRunTheWrongWay) {
  const PixelGrid grid{-2, -2, 0.1, 40, 40};
  const PaintedImage image = painted({loop(ellipse(0, 0, 1, 1, 0), {0}, false)}, grid);
  ASSERT_FALSE(image.windings.empty());
  for (const PaintedImage::Winding &winding : image.windings) EXPECT_EQ(winding.times, -1);
}

TEST(PathPainter, KnowsWhatPassesNear) {
  const Path circle = {PathArc{{0, 0}, {5, 5}, 0.25, 0 - 0.25, pi / 2 - 0.25, {5, 0}, {0, 5}}};
  EXPECT_TRUE(passes_near(circle, 3 + 3e-7, 4 + 4e-7, 1e-6));
  EXPECT_FALSE(passes_near(circle, 3 + 9e-7, 4 + 12e-7, 1e-6));
  EXPECT_FALSE(passes_near(circle, 3, -4, 1e-6));  // the circle goes there, the arc does not
  EXPECT_TRUE(passes_near(circle, 5, -5e-7, 1e-6));
}

}  // namespace
