// Cubics along arcs of circles and ellipses: how many there are, how far they leave the arc, and what is alike.
#include "picture/cubic_arcs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

namespace {

using Point = std::array<double, 2>;
using Cubic = std::array<int64_t, 6>;

constexpr int decimals = 2;
constexpr double unit = 0.01;

hsp::PageArc arc_of(Point centre, double a, double b, double turned, double from, double to, bool circle) {
  const double c = std::cos(turned), s = std::sin(turned);
  const auto at = [&](double t) {
    const double x = a * std::cos(t), y = b * std::sin(t);
    return hsp::PagePoint{centre[0] + c * x - s * y, centre[1] + s * x + c * y};
  };
  return {{centre[0], centre[1]}, {a * c, a * s}, {-b * s, b * c}, {a, b}, from, to, at(from), at(to), circle};
}

std::vector<Cubic> cubics_of(const hsp::PageArc &arc) {
  std::vector<Cubic> cubics;
  hsp::CubicArc(arc, decimals).visit([&](const hsp::UnitPoint &a, const hsp::UnitPoint &b, const hsp::UnitPoint &end) {
    cubics.push_back({a.x, a.y, b.x, b.y, end.x, end.y});
  });
  return cubics;
}

// How far they leave the ellipse, in units: the distance of points from it along the gradient, to first order.
double away(const hsp::PageArc &arc, const std::vector<Cubic> &cubics) {
  double worst = 0;
  Point from = {std::round(arc.start.x / unit), std::round(arc.start.y / unit)};
  for (const Cubic &cubic : cubics) {
    for (int k = 0; k <= 16; ++k) {
      const double t = k / 16.0, u = 1 - t;
      Point at{};
      for (size_t i = 0; i < 2; ++i) {
        at[i] = u * u * u * from[i] + 3 * u * u * t * static_cast<double>(cubic[i]) +
                3 * u * t * t * static_cast<double>(cubic[2 + i]) + t * t * t * static_cast<double>(cubic[4 + i]);
      }
      const double x = at[0] * unit - arc.centre.x, y = at[1] * unit - arc.centre.y;
      const double a = arc.semi_axis[0], b = arc.semi_axis[1];
      const double p = (x * arc.major.x + y * arc.major.y) / (a * a), q = (x * arc.minor.x + y * arc.minor.y) / (b * b);
      const double level = std::sqrt(p * p + q * q);
      const double slope = std::sqrt(p * p / (a * a) + q * q / (b * b)) / level;
      worst = std::max(worst, std::fabs(level - 1) / slope / unit);
    }
    from = {static_cast<double>(cubic[4]), static_cast<double>(cubic[5])};
  }
  return worst;
}

TEST(CubicArcs, StayWithinTwoUnits) {
  for (const double r : {0.02, 1.0, 30.0, 36.0, 37.0, 1000.0, 1e6}) {
    for (const double flat : {1.0, 0.5, 0.1}) {
      for (const double from : {-3.0, 0.1, 2.0}) {
        for (const double span : {0.01, 1.5, 3.1, 6.2, -0.3, -6.0}) {
          if (r * flat < 1) continue;  // the distance is known to first order
          const hsp::PageArc arc = arc_of({123.456, -7.89}, r, r * flat, 0.7, from, from + span, flat == 1.0);
          EXPECT_LE(away(arc, cubics_of(arc)), 2.0) << r << ' ' << flat << ' ' << from << ' ' << span;
        }
      }
    }
  }
}

TEST(CubicArcs, AreAsLongAsThatAllows) {
  for (const double r : {1.0, 36.0, 40.0, 1000.0, 1e6}) {
    uint32_t parts = 4;
    const auto deviation = [](uint32_t n) {
      const double quarter = std::numbers::pi / 2 / n;
      return 2.0 / 27 * std::pow(std::sin(quarter), 6) / std::pow(std::cos(quarter), 2);
    };
    while (deviation(parts) * r > unit) ++parts;
    EXPECT_EQ(hsp::parts_of_turn(r / unit), parts) << r;
    const double step = 2 * std::numbers::pi / parts;
    EXPECT_EQ(cubics_of(arc_of({0, 0}, r, r / 2, 0, 0.2, 0.2 + 0.99 * step, false)).size(), 1U);
    EXPECT_EQ(cubics_of(arc_of({0, 0}, r, r / 2, 0, 0.2, 0.2 + 2.01 * step, false)).size(), 3U);
    // A circle's are cut where parts of a whole turn meet, unless one suffices.
    EXPECT_EQ(cubics_of(arc_of({0, 0}, r, r, 0, 0.9 * step, 1.8 * step, true)).size(), 1U);
    EXPECT_EQ(cubics_of(arc_of({0, 0}, r, r, 0, 0.9 * step, 2.1 * step, true)).size(), 3U);
    EXPECT_EQ(cubics_of(arc_of({0, 0}, r, r, 0, 0.0, 2 * std::numbers::pi, true)).size(), parts);
    EXPECT_EQ(cubics_of(arc_of({0, 0}, r, r, 0, 2 * std::numbers::pi, 0.0, true)).size(), parts);
  }
}

// From the centre on, parts of circles that are neither the first nor the last are the same wherever arcs begin.
TEST(CubicArcs, OfEqualCirclesAreAlike) {
  std::set<Cubic> seen;
  for (int k = 0; k < 50; ++k) {
    const Point centre = {3.14159 * k, -2.71828 * k};
    const hsp::PageArc arc = arc_of(centre, 12.345, 12.345, 0, 0.06 * k - 3, 0.06 * k + 3, true);
    const std::vector<Cubic> cubics = cubics_of(arc);
    const hsp::UnitPoint at = hsp::in_units(arc.centre, decimals);
    for (size_t c = 1; c + 1 < cubics.size(); ++c) {
      Cubic moved = cubics[c];
      for (size_t i = 0; i < 6; ++i) moved[i] -= i % 2 == 0 ? at.x : at.y;
      seen.insert(moved);
    }
  }
  EXPECT_EQ(seen.size(), 4U);
}

// Both ways the same points: where regions meet, one goes along an arc as the other one comes back.
TEST(CubicArcs, AreTheSameBackwards) {
  for (const bool circle : {true, false}) {
    const double b = circle ? 20 : 7;
    const hsp::PageArc there = arc_of({55.5551, 44.4449}, 20, b, 0.3, -2, 3.3, circle);
    const hsp::PageArc back = arc_of({55.5551, 44.4449}, 20, b, 0.3, 3.3, -2, circle);
    std::vector<hsp::UnitPoint> forward = {hsp::in_units(there.start, decimals)}, backward;
    for (const Cubic &c : cubics_of(there)) {
      for (size_t k = 0; k < 6; k += 2) forward.push_back({c[k], c[k + 1]});
    }
    for (const Cubic &c : cubics_of(back)) {
      for (size_t k = 0; k < 6; k += 2) backward.push_back({c[k], c[k + 1]});
    }
    std::reverse(backward.begin(), backward.end());
    backward.push_back(hsp::in_units(there.end, decimals));
    ASSERT_EQ(forward.size(), backward.size());
    for (size_t k = 0; k < forward.size(); ++k) {
      EXPECT_EQ(forward[k].x, backward[k].x) << k;
      EXPECT_EQ(forward[k].y, backward[k].y) << k;
    }
  }
}

}  // namespace
