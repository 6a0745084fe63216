// Areas and enclosed volumes of shells against the balls' own measures and closed forms, and the invariant about their
// signs.
#include "measure/shell_volumes.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "built_topology.hpp"
#include "point_lattices.hpp"
#include "random_balls.hpp"

namespace {

using hsp::BallMeasure;
using hsp::TopologyInvariant;
using hsp::TopologyViolation;

constexpr double pi = std::numbers::pi;

// A closed wall.
oracle::Balls cage_of_30() {
  return oracle::balls_on_sphere(3, 1000, 1900);
}

BallMeasure shell_of(BuiltTopology &built, uint32_t shell) {
  return measure_shell(built.balls(), built.boundary(), built.structure(), shell);
}
TopologyViolation checked(BuiltTopology &built) {
  return check_enclosed_volumes(built.balls(), built.boundary(), built.structure());
}

TEST(ShellMeasures, OfOneBall) {
  BuiltTopology built(oracle::Balls{{5, 6, 7, 1000}});
  const BallMeasure measure = shell_of(built, 0);
  EXPECT_NEAR(measure.area, 4e6 * pi, 1e-8);
  EXPECT_NEAR(measure.volume, 4e9 / 3 * pi, 1e-5);
  EXPECT_EQ(checked(built).invariant, TopologyInvariant::none);
}

// A lens-shaped pair and a ball inside a cage: three shells beside the cage's own two.
TEST(ShellMeasures, SumToThoseOfTheBalls) {
  oracle::Balls balls = cage_of_30();
  balls.push_back({0, 0, 0, 200});
  balls.push_back({20000, 0, 0, 1000});
  balls.push_back({21000, 300, 0, 900});
  BuiltTopology built(balls);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  ASSERT_EQ(built.structure().shell_count, 4U);
  double area = 0.0, volume = 0.0;
  double shells_area = 0.0, shells_volume = 0.0;
  for (uint32_t i = 0; i < built.balls().n; ++i) {
    const BallMeasure measure = measure_ball(built.balls(), built.boundary(), i);
    area += measure.area;
    volume += measure.volume;
  }
  int voids = 0;
  for (uint32_t s = 0; s < built.structure().shell_count; ++s) {
    const BallMeasure measure = shell_of(built, s);
    EXPECT_GT(measure.area, 0.0);
    EXPECT_EQ(measure.volume < 0.0, built.structure().shells[s].is_void);
    voids += built.structure().shells[s].is_void ? 1 : 0;
    shells_area += measure.area;
    shells_volume += measure.volume;
  }
  EXPECT_EQ(voids, 1);
  EXPECT_NEAR(shells_area, area, 1e-12 * area);
  EXPECT_NEAR(shells_volume, volume, 1e-12 * volume);
  EXPECT_EQ(checked(built).invariant, TopologyInvariant::none);
}

// A face that is cut into several simple faces counts once.
TEST(ShellMeasures, CountCutFacesOnce) {
  BuiltTopology built(oracle::Balls{{0, 0, 0, 1000}, {1000, 0, 0, 100}, {0, 1000, 0, 100}, {0, 0, -1000, 100}});
  ASSERT_EQ(built.status(), hsp::Status::ok);
  ASSERT_EQ(built.structure().shell_count, 1U);
  ASSERT_GT(built.structure().face_count, built.boundary().face_count() + 1);
  double area = 0.0, volume = 0.0;
  for (uint32_t i = 0; i < built.balls().n; ++i) {
    const BallMeasure measure = measure_ball(built.balls(), built.boundary(), i);
    area += measure.area;
    volume += measure.volume;
  }
  const BallMeasure measure = shell_of(built, 0);
  EXPECT_NEAR(measure.area, area, 1e-12 * area);
  EXPECT_NEAR(measure.volume, volume, 1e-12 * volume);
  // Three bumps add a little to the ball: less than their own volume.
  EXPECT_GT(measure.volume, 4e9 / 3 * pi);
  EXPECT_LT(measure.volume, 4e9 / 3 * pi + 3 * 4e6 / 3 * pi);
}

TEST(ShellMeasures, LawOfSigns) {
  oracle::Balls balls = cage_of_30();
  balls.push_back({0, 0, 0, 200});
  BuiltTopology built(balls);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  for (uint32_t s = 0; s < built.structure().shell_count; ++s) {
    bool &is_void = built.structure().shells[s].is_void;
    is_void = !is_void;
    EXPECT_EQ(checked(built).invariant, TopologyInvariant::volumes);
    EXPECT_EQ(checked(built).id, s);
    is_void = !is_void;
  }
  EXPECT_EQ(checked(built).invariant, TopologyInvariant::none);
}

// Balls of radius 0 and gaps of no volume: 0 is as good as either sign.
TEST(ShellMeasures, LawOfSignsAllowsForRounding) {
  oracle::RandomSource random(1);
  for (int k = 0; k < 300; ++k) {
    const oracle::Balls balls = oracle::degenerate_balls(random, static_cast<std::size_t>(random.in(1, 12)));
    BuiltTopology built(balls);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    ASSERT_EQ(checked(built).invariant, TopologyInvariant::none) << oracle::to_text(balls);
  }
  BuiltTopology point(oracle::Balls{{1, 2, 3, 0}});
  EXPECT_EQ(shell_of(point, 0).area, 0.0);
  EXPECT_EQ(checked(point).invariant, TopologyInvariant::none);
  // Eight spheres that meet in the middle of their box wall a void of no volume.
  BuiltTopology closed(oracle::box_lattice({2, 2, 2}, {4, 6, 12}, 7));
  ASSERT_EQ(closed.status(), hsp::Status::ok);
  EXPECT_EQ(checked(closed).invariant, TopologyInvariant::none);
}

struct Cell {
  double area, volume;
  uint32_t enclosing_shell, components, shells;
};

TEST(CellMeasures, OfACageWithABallInItAndOneOutside) {
  oracle::Balls balls = cage_of_30();
  balls.push_back({0, 0, 0, 200});
  balls.push_back({20000, 0, 0, 1000});
  BuiltTopology built(balls);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  Cell cells[2] = {{9, 9, 9, 9, 9}, {9, 9, 9, 9, 9}};
  ASSERT_EQ(built.structure().cell_count, 2U);
  measure_cells(built.balls(), built.boundary(), built.structure(), hsp::Span<Cell>(cells, 2));
  EXPECT_EQ(cells[0].volume, 0.0);
  EXPECT_EQ(cells[0].enclosing_shell, hsp::no_id);
  EXPECT_EQ(cells[0].components, 2U);
  EXPECT_EQ(cells[0].shells, 2U);
  EXPECT_EQ(cells[1].components, 1U);
  EXPECT_EQ(cells[1].shells, 2U);
  const uint32_t enclosing = cells[1].enclosing_shell;
  ASSERT_LT(enclosing, built.structure().shell_count);
  ASSERT_TRUE(built.structure().shells[enclosing].is_void);
  const BallMeasure around = shell_of(built, enclosing);
  EXPECT_NEAR(cells[1].area, around.area + 4 * pi * 200 * 200, 1e-12 * around.area);
  EXPECT_NEAR(cells[1].volume, -around.volume - 4.0 / 3 * pi * 200 * 200 * 200, -1e-12 * around.volume);
  double area = 0.0;
  for (uint32_t s = 0; s < built.structure().shell_count; ++s) area += shell_of(built, s).area;
  EXPECT_NEAR(cells[0].area + cells[1].area, area, 1e-12 * area);
}

}  // namespace
