// A set with many balls inside its balls, so many that cubes are crowded, against the set without them: their union is
// the same.
#include <gtest/gtest.h>

#include <algorithm>

#include "library_run.hpp"
#include "random_balls.hpp"
#include "sweep_length.hpp"

namespace {

using oracle::Balls;
using oracle::LatticeBall;
using oracle::RandomSource;

// One inside the ball: anywhere, touching it from within, or equal to it.
LatticeBall inside(RandomSource &random, const LatticeBall &ball) {
  LatticeBall inner = ball;
  const int64_t room = ball.radius / 2;
  switch (random.in(0, 2)) {
    case 0:
      inner.x += random.in(-room / 2, room / 2);
      inner.y += random.in(-room / 2, room / 2);
      inner.z += random.in(-room / 2, room / 2);
      inner.radius = random.in(0, ball.radius / 10);
      break;
    case 1:
      inner.radius = random.in(0, ball.radius);
      inner.x += ball.radius - inner.radius;
      break;
    default:
      break;
  }
  return inner;
}

TEST(NestedBalls, ChangeNothing) {
  RandomSource random(17);
  for (int k = 0; k < oracle::rounds(30, 400); ++k) {
    Balls alone;
    for (LatticeBall ball : oracle::dense_balls(random, static_cast<size_t>(random.in(1, 7)))) {
      for (int64_t *const length : {&ball.x, &ball.y, &ball.z, &ball.radius}) *length *= 40;
      alone.push_back(ball);
    }
    const size_t outer = alone.size();
    Balls balls = alone;
    // Most lie in one of them, which is the largest of all or is not.
    const size_t favourite = static_cast<size_t>(random.in(0, static_cast<int64_t>(outer) - 1));
    for (int inner = 0; inner < 150; ++inner) {
      const bool usual = random.in(0, 9) > 0;
      const size_t of = usual ? favourite : static_cast<size_t>(random.in(0, static_cast<int64_t>(outer) - 1));
      balls.push_back(inside(random, balls[of]));
    }
    const LibraryBoundary expected(alone), found(balls);
    const hsp_boundary_counts without = expected.counts(), with = found.counts();
    ASSERT_EQ(with.vertices, without.vertices) << k;
    ASSERT_EQ(with.arcs, without.arcs) << k;
    ASSERT_EQ(with.circles, without.circles) << k;
    ASSERT_EQ(with.faces, without.faces) << k;
    ASSERT_EQ(with.shells, without.shells) << k;
    ASSERT_EQ(with.components, without.components) << k;
    const LibraryBoundary::Measures of_all = found.measure(), of_outer = expected.measure();
    EXPECT_NEAR(of_all.totals.area, of_outer.totals.area, 1e-12 * of_outer.totals.area);
    EXPECT_NEAR(of_all.totals.volume, of_outer.totals.volume, 1e-12 * of_outer.totals.volume);
    // Of equal balls the one that has the area may be any.
    const auto component = [](const LibraryBoundary &of, size_t ball) { return of.balls()[ball].component; };
    for (size_t i = outer; i < balls.size(); i += 7) {
      bool joined = false;
      for (size_t j = 0; j < outer; ++j) joined = joined || component(found, j) == component(found, i);
      EXPECT_TRUE(joined) << "ball " << i;
    }
  }
}

// Of one centre: the largest alone is left, whatever their order.
TEST(NestedBalls, OfOneCentre) {
  RandomSource random(18);
  for (int k = 0; k < 8; ++k) {
    Balls balls;
    for (int ball = 0; ball < 700; ++ball) balls.push_back({5, -3, 2, random.in(0, 100000)});
    int64_t largest = 0;
    for (const LatticeBall &ball : balls) largest = std::max(largest, ball.radius);
    const LibraryBoundary boundary(balls);
    const hsp_boundary_counts counts = boundary.counts();
    EXPECT_EQ(counts.faces, 1U);
    EXPECT_EQ(counts.components, 1U);
    EXPECT_EQ(counts.vertices + counts.arcs + counts.circles, 0U);
    const double r = static_cast<double>(largest);
    EXPECT_NEAR(boundary.measure().totals.area, 12.566370614359172 * r * r, 1e-12 * 12.6 * r * r);
  }
}

}  // namespace
