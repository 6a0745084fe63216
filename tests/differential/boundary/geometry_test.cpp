// The numbers that come with the boundary (positions, angles, circles) against the definition of what they measure.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "library_run.hpp"
#include "named_balls.hpp"
#include "random_balls.hpp"
#include "smallest_failing.hpp"

namespace {

using oracle::Balls;
using oracle::LatticeBall;
using oracle::RandomSource;
using Point = std::array<double, 3>;

double dot(const Point &a, const Point &b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Point cross(const Point &a, const Point &b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Point sum(const Point &a, double s, const Point &b, double t, const Point &c) {
  return {a[0] + s * b[0] + t * c[0], a[1] + s * b[1] + t * c[1], a[2] + s * b[2] + t * c[2]};
}
Point difference(const Point &a, const Point &b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
double length(const Point &a) {
  return std::sqrt(dot(a, a));
}
Point centre(const LatticeBall &b) {
  return {static_cast<double>(b.x), static_cast<double>(b.y), static_cast<double>(b.z)};
}

/// Collects what is wrong; lengths are compared up to a tolerance relative to the largest radius.
class Numbers {
 public:
  explicit Numbers(const Balls &balls) : balls_(balls), boundary_(balls), vertices_(boundary_.vertices()) {
    for (const LatticeBall &ball : balls) largest_ = std::max(largest_, static_cast<double>(ball.radius));
  }

  std::string complaint() {
    for (const hsp_vertex &vertex : vertices_) check(vertex);
    for (const hsp_arc &arc : boundary_.arcs()) check(arc);
    for (const hsp_circle &circle : boundary_.circles()) check(circle);
    return text_;
  }

 private:
  void expect_length(double value, double expected, double tolerance, const char *what) {
    if (!(std::abs(value - expected) <= tolerance * largest_))
      text_ += std::string(what) + ": " + std::to_string(value) + " instead of " + std::to_string(expected) + "\n";
  }
  void expect_outside(const Point &point, double tolerance, const char *what) {
    for (const LatticeBall &ball : balls_)
      if (!(length(difference(point, centre(ball))) >= static_cast<double>(ball.radius) - tolerance * largest_))
        text_ += std::string(what) + " lies in " + oracle::to_text({ball}) + "\n";
  }

  void check(const hsp_vertex &vertex) {
    const Point point = {vertex.xyz[0], vertex.xyz[1], vertex.xyz[2]};
    for (const std::uint32_t ball : vertex.ball)
      expect_length(length(difference(point, centre(balls_[ball]))), static_cast<double>(balls_[ball].radius), 1e-14,
                    "distance of a vertex");
    expect_outside(point, 1e-14, "a vertex");
    const Point a = centre(balls_[vertex.ball[0]]);
    const Point n = cross(difference(centre(balls_[vertex.ball[1]]), a), difference(centre(balls_[vertex.ball[2]]), a));
    const double side = dot(difference(point, a), n) / length(n) * vertex.sign;
    if (!(side >= -1e-14 * largest_)) text_ += "a vertex is on the wrong side\n";
    if (vertex.reserved != 0) text_ += "reserved is not 0\n";
  }

  void check(const hsp_arc &arc) {
    if (!(arc.angle >= 0 && arc.angle <= 2 * std::numbers::pi)) text_ += "an angle out of range\n";
    const LatticeBall &a = balls_[arc.ball[0]];
    const LatticeBall &b = balls_[arc.ball[1]];
    const auto &[c, axis] = centre_and_axis(a, b);
    const double *from = vertices_[arc.vertex[0]].xyz;
    const double *to = vertices_[arc.vertex[1]].xyz;
    const Point start = difference({from[0], from[1], from[2]}, c);
    const Point left = cross(axis, start);
    // Turning the start by the angle leads to the end, and half of it to a point outside all balls: the angle is right,
    // not just right up to a whole turn.
    const Point end = sum(c, std::cos(arc.angle), start, std::sin(arc.angle), left);
    expect_length(length(difference(end, {to[0], to[1], to[2]})), 0, 1e-12, "end of an arc");
    expect_outside(sum(c, std::cos(arc.angle / 2), start, std::sin(arc.angle / 2), left), 1e-12, "middle of an arc");
  }

  void check(const hsp_circle &circle) {
    const LatticeBall &a = balls_[circle.ball[0]];
    const LatticeBall &b = balls_[circle.ball[1]];
    const auto &[c, axis] = centre_and_axis(a, b);
    const Point found_centre = {circle.centre[0], circle.centre[1], circle.centre[2]};
    const Point found_axis = {circle.axis[0], circle.axis[1], circle.axis[2]};
    expect_length(length(difference(found_centre, c)), 0, 1e-14, "centre of a circle");
    expect_length(largest_ * length(difference(found_axis, axis)), 0, 1e-14, "axis of a circle");
    const double height = length(difference(c, centre(a)));
    // Squares: near a tangency the root would blow up the rounding of the heights here.
    const double radius = static_cast<double>(a.radius);
    if (!(std::abs(circle.radius * circle.radius + height * height - radius * radius) <= 1e-14 * largest_ * largest_))
      text_ += "radius of a circle\n";
  }

  static std::array<Point, 2> centre_and_axis(const LatticeBall &a, const LatticeBall &b) {
    const Point v = difference(centre(b), centre(a));
    const double square = dot(v, v);
    const double share = (square + static_cast<double>(a.radius * a.radius - b.radius * b.radius)) / (2 * square);
    return {sum(centre(a), share, v, 0, v), {v[0] / length(v), v[1] / length(v), v[2] / length(v)}};
  }

  const Balls &balls_;
  LibraryBoundary boundary_;
  std::vector<hsp_vertex> vertices_;
  double largest_ = 0;
  std::string text_;
};

std::string numbers_are_wrong(const Balls &balls) {
  return Numbers(balls).complaint();
}

TEST(BoundaryNumbers, FitRandomSets) {
  RandomSource random(51);
  for (int k = 0; k < 4000; ++k) {
    const Balls balls = oracle::any_balls(random, static_cast<std::size_t>(random.in(2, 25)));
    ASSERT_EQ(complaint_about_smallest(balls, numbers_are_wrong), "");
  }
}

TEST(BoundaryNumbers, FitDegenerateSets) {
  RandomSource random(52);
  for (int k = 0; k < 8000; ++k) {
    const Balls balls = oracle::degenerate_balls(random, static_cast<std::size_t>(random.in(2, 14)));
    ASSERT_EQ(complaint_about_smallest(balls, numbers_are_wrong), "");
  }
}

TEST(BoundaryNumbers, FitCrownedSets) {
  RandomSource random(53);
  for (int k = 0; k < 1000; ++k)
    ASSERT_EQ(complaint_about_smallest(oracle::crowned_balls(random, 25), numbers_are_wrong), "");
}

TEST(BoundaryNumbers, FitNamedSets) {
  for (const oracle::NamedBalls &set : oracle::named_balls())
    EXPECT_EQ(complaint_about_smallest(set.balls, numbers_are_wrong), "") << set.name;
}

}  // namespace
