// Turning the balls and looking along z is looking at the balls from elsewhere.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "view_complaints.hpp"
#include "view_sets.hpp"

namespace {

using oracle::Balls;
using Matrix = std::array<Direction, 3>;  // rows

Matrix product(const Matrix &a, const Matrix &b) {
  Matrix result{};
  for (size_t i = 0; i < 3; ++i)
    for (size_t j = 0; j < 3; ++j)
      for (size_t k = 0; k < 3; ++k) result[i][j] += a[i][k] * b[k][j];
  return result;
}

// Counter-clockwise about an axis, seen from its positive end.
Matrix turn_about(size_t axis, double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  const size_t next = (axis + 1) % 3;
  const size_t last = (axis + 2) % 3;
  Matrix m{};
  m[axis][axis] = 1;
  m[next][next] = m[last][last] = std::cos(angle);
  m[next][last] = -std::sin(angle);
  m[last][next] = std::sin(angle);
  return m;
}

// About x, then y, then z.
Matrix turn(double x, double y, double z) {
  return product(turn_about(2, z), product(turn_about(1, y), turn_about(0, x)));
}

Balls turned(const Balls &balls, const Matrix &m) {
  Balls result;
  for (const oracle::LatticeBall &b : balls) {
    const auto row = [&](size_t k) {
      return std::llround(m[k][0] * static_cast<double>(b.x) + m[k][1] * static_cast<double>(b.y) +
                          m[k][2] * static_cast<double>(b.z));
    };
    result.push_back({row(0), row(1), row(2), b.radius});
  }
  return result;
}

// Where each ball is seen relative to the first, and the area of its piece.
struct Seen {
  Direction place{};
  double area = 0;
};
std::vector<Seen> seen(const Balls &balls, const ViewChoice &choice) {
  const LibraryScene scene(balls);
  const ViewRecords view = view_of(scene, choice);
  const std::vector<oracle::PlainBall> places = oracle::seen_along(scene.balls(), view.axes());
  std::vector<Seen> result(balls.size());
  for (size_t i = 0; i < balls.size(); ++i)
    for (size_t k = 0; k < 3; ++k) result[i].place[k] = places[i].centre[k] - places[0].centre[k];
  const std::vector<oracle::Path> paths = view.paths();
  for (size_t p = 0; p < paths.size(); ++p) result[view.pieces[p].ball].area = area_of(paths[p]);
  return result;
}

void expect_same_view(const Balls &balls, const Matrix &m, const Direction &towards, const Direction &up,
                      double tolerance) {
  const Balls other = turned(balls, m);
  for (ViewChoice choice : all_choices(towards, up)) {
    if ((choice.flags & HSP_VIEW_ALL_BALLS) == 0) continue;  // what is left out is not promised
    const std::vector<Seen> one = seen(balls, choice);
    choice.towards = choice.up = {};
    const std::vector<Seen> two = seen(other, choice);
    for (size_t i = 0; i < balls.size(); ++i) {
      const auto r = static_cast<double>(balls[i].radius);
      for (size_t k = 0; k < 3; ++k)
        ASSERT_NEAR(one[i].place[k], two[i].place[k], tolerance * static_cast<double>(balls[0].radius));
      ASSERT_NEAR(one[i].area, two[i].area, tolerance * r * r) << "ball " << i << ", " << choice.text();
    }
  }
}

// Loose balls without equal coordinates, of which the order at equal depths would depend on the axes.
Balls balls_without_ties(oracle::RandomSource &random, size_t n) {
  constexpr int64_t factor = 1 << 20;
  Balls balls = oracle::loose_balls(random, n);
  for (oracle::LatticeBall &ball : balls)
    ball = {ball.x * factor + random.in(0, factor - 1), ball.y * factor + random.in(0, factor - 1),
            ball.z * factor + random.in(0, factor - 1), ball.radius * factor};
  return balls;
}

hsp_view_options options_turned(double x, double y, double z) {
  hsp_view_options options;
  expect_ok(hsp_view_options_init(&options, sizeof options), "hsp_view_options_init");
  expect_ok(hsp_view_options_turn(&options, x, y, z), "hsp_view_options_turn");
  return options;
}

TEST(TurnedViews, ByQuarterTurnsAreTheSame) {
  oracle::RandomSource random(97);
  const Balls balls = balls_without_ties(random, 80);
  for (int quarter = 0; quarter < 64; ++quarter) {
    const double x = 90 * (quarter % 4);
    const double y = 90 * (quarter / 4 % 4);
    const double z = 90 * (quarter / 16) - 90;
    const Matrix m = turn(x, y, z);
    const hsp_view_options options = options_turned(x, y, z);
    for (size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(options.towards[k], std::round(m[2][k]));  // exact
      EXPECT_EQ(options.up[k], std::round(m[1][k]));
    }
    if (quarter % 7 == 0) expect_same_view(balls, m, std::to_array(options.towards), std::to_array(options.up), 1e-9);
  }
}

TEST(TurnedViews, ByAnyAnglesAreTheSameUpToRounding) {
  oracle::RandomSource random(98);
  for (int k = 0; k < 10; ++k) {
    const Balls balls = balls_without_ties(random, 80);
    const auto angle = [&] { return static_cast<double>(random.in(-3600000, 3600000)) / 10000; };
    const double x = angle();
    const double y = angle();
    const double z = angle();
    const hsp_view_options options = options_turned(x, y, z);
    expect_same_view(balls, turn(x, y, z), std::to_array(options.towards), std::to_array(options.up), 2e-6);
  }
}

TEST(TurnedViews, ByDirectionsOfAnyLength) {
  oracle::RandomSource random(99);
  const Balls balls = oracle::loose_balls(random, 30);
  const LibraryScene scene(balls);
  EXPECT_EQ(view_invariant_broken(balls, {0.25, -0.5, 1}, {0, 1, 0.5}), "");
  for (const ViewChoice &choice : all_choices({0.25, -0.5, 1}, {0, 1, 0.5})) {
    const ViewRecords one = view_of(scene, choice);
    ViewChoice longer = choice;
    for (double &component : longer.towards) component *= 0x1p700;
    for (double &component : longer.up) component *= 0x1p-700;
    const ViewRecords other = view_of(scene, longer);
    EXPECT_EQ(one.axes().towards, other.axes().towards);
    EXPECT_EQ(one.axes().up, other.axes().up);
    ASSERT_EQ(one.arcs.size(), other.arcs.size());
    for (size_t a = 0; a < one.arcs.size(); ++a) EXPECT_EQ(one.arcs[a].start[0], other.arcs[a].start[0]);
  }
}

TEST(TurnedViews, HaveTheUpThatIsLeft) {
  for (const Direction &towards : {Direction{}, {0, 0, 2}, {0, 3, 0}, {0, -1, 0}, {-1, 0, 0}, {1, 2, 3}})
    for (const Direction &up : {Direction{}, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {1, 2, 3}, {0, 4, -1}, {-2, -4, -6}})
      EXPECT_EQ(view_invariant_broken({{0, 0, 0, 5}, {4, 4, 4, 5}}, towards, up), "");
}

}  // namespace
