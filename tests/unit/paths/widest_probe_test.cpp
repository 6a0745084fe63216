// The widest probe where it is known in closed form, and among random balls.
#include "paths/widest_probe.hpp"

#include <gtest/gtest.h>

#include "checked_probe.hpp"
#include "sweep_length.hpp"

namespace {

using namespace checked_probe;

TEST(WidestProbe, AmongNoBallsOneAndTwo) {
  const Vector from{2000, 0, 0}, to{-3000, 0, 0}, inside{10, 0, 0};
  const BuiltProbe free({}, from, &to);
  ASSERT_EQ(free.status(), hsp::Status::ok);
  EXPECT_TRUE(free.widest().passes);
  EXPECT_EQ(free.widest().radius, INFINITY);
  EXPECT_EQ(free.widest().gate[0], no_id);
  for (const Vector *end : {&to, static_cast<const Vector *>(nullptr), &from}) {
    const BuiltProbe one({{0, 0, 0, 1000}}, from, end);
    ASSERT_EQ(one.status(), hsp::Status::ok);
    EXPECT_TRUE(one.widest().passes);
    EXPECT_EQ(one.widest().radius, 1000.0);
    EXPECT_EQ(one.widest().gate[0], 0U);
    EXPECT_EQ(one.widest().gate[1], no_id);
  }
  const BuiltProbe two({{0, 0, 0, 1000}, {-3000, 700, 0, 200}}, from, &to);
  EXPECT_EQ(two.widest().radius, 500.0);
  EXPECT_EQ(two.widest().gate[0], 1U);
  const BuiltProbe covered({{0, 0, 0, 1000}}, from, &inside);
  ASSERT_EQ(covered.status(), hsp::Status::ok);
  EXPECT_FALSE(covered.widest().passes);
  EXPECT_EQ(covered.widest().gate[0], no_id);
  const BuiltProbe touching({{0, 0, 0, 2000}}, from, nullptr);
  EXPECT_FALSE(touching.widest().passes);
}

// Beside all centres nothing is built, so that no ball has to fit a lattice when it grows that much. Between them it
// has to.
TEST(WidestProbe, BesideAndBetweenFarBalls) {
  const int64_t far = INT64_C(1) << 31;
  Balls balls;
  for (const int64_t side : {far, -far}) {
    balls.push_back({side, 0, 0, 1000});
    balls.push_back({0, side, 0, 1000});
    balls.push_back({0, 0, side, 1000});
  }
  const Vector beside{8 * far, 5, 5}, other{7, -far, 9};
  const BuiltProbe away(balls, beside, nullptr);
  ASSERT_EQ(away.status(), hsp::Status::ok);
  EXPECT_TRUE(away.widest().passes);
  EXPECT_NEAR(away.widest().radius, static_cast<double>(7 * far - 1000), 1.0);
  EXPECT_EQ(away.widest().gate[0], 0U);
  EXPECT_EQ(away.widest().gate[1], no_id);
  EXPECT_EQ(away.builds(), 0U);
  const BuiltProbe covered(balls, beside, &other);
  ASSERT_EQ(covered.status(), hsp::Status::ok);
  EXPECT_EQ(covered.widest().passes, false);
  const BuiltProbe between(balls, {0, 0, 0}, nullptr);
  EXPECT_EQ(between.status(), hsp::Status::range);
}

// The hole of a ring of three, in closed form: the circumradius of the triangle less their radius.
TEST(WidestProbe, ThroughARingOfThree) {
  const int64_t unit = 1000000;
  Balls balls{{2 * unit, 0, 0, unit}, {-unit, 1732051, 0, unit}, {-unit, -1732051, 0, unit}};
  // The ring is a hole in a lid; what is below has walls and a floor.
  for (int64_t x = -6; x <= 6; ++x) {
    for (int64_t y = -6; y <= 6; ++y) {
      if (x * x + y * y > 9) balls.push_back({x * unit, y * unit, 0, unit + unit / 2});
      if (x % 2 != 0 || y % 2 != 0) continue;
      const bool at_wall = std::max(std::abs(x), std::abs(y)) == 6;
      for (int64_t z = -6; z < (at_wall ? 0 : -4); z += 2) {
        balls.push_back({x * unit, y * unit, z * unit, unit + unit / 2});
      }
    }
  }
  const BuiltProbe built(balls, {0, 0, -3 * unit}, nullptr);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  ASSERT_TRUE(built.widest().passes);
  // With h = 1732051 the centre is at x = (3 unit^2 - h^2) / (6 unit).
  EXPECT_NEAR(built.widest().radius, static_cast<double>(unit) + 666601 / 6e6, 1e-4);
  EXPECT_EQ(built.widest().gate[0], 0U);
  EXPECT_EQ(built.widest().gate[1], 1U);
  EXPECT_EQ(built.widest().gate[2], 2U);
  EXPECT_LE(built.builds(), 40U);
}

TEST(WidestProbe, AmongRandomBalls) {
  oracle::RandomSource random(1);
  Seen seen;
  ASSERT_NO_FATAL_FAILURE(check_among_random_balls(random, oracle::sets(4), seen));
  EXPECT_GT(seen.gates + seen.touches, 0U);
}

}  // namespace
