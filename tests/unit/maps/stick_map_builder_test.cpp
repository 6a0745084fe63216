// Pictures of balls and sticks without a drawing order, against the z-buffer of balls and cylinders: no pixel differs.
#include "maps/stick_map_builder.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "built_sticks.hpp"
#include "molecule_balls.hpp"
#include "point_lattices.hpp"
#include "random_balls.hpp"
#include "touching_balls.hpp"

namespace {

using Ends = std::vector<BuiltSticks::Ends>;
using oracle::Balls;

constexpr Direction along_z{0, 0, 1};

// Evenly spread, turned a little.
Direction one_of(int k, int count) {
  const double z = 1 - (2 * k + 1.0) / count, r = std::sqrt(1 - z * z), angle = 2.39996323 * k + 0.1;
  return {r * std::cos(angle), r * std::sin(angle), z};
}

void expect_map(const BuiltSticks &built, const char *reason, size_t pixels) {
  EXPECT_EQ(built.violation().substr(0, 2), reason);
  EXPECT_TRUE(built.builder().map().exist);
  EXPECT_EQ(sticks_disagree(built, pixels), "");
}

// Sticks around a polygon, each over the next one: high where it leaves the middle and low at the other end, with both
// crossings in its first half.
StickModel carton(int corners) {
  StickModel model;
  for (int k = 0; k < corners; ++k) {
    const double angle = 6.283185307179586 * k / corners;
    const auto at = [&](double along, double beside, double height) {
      model.balls.push_back({std::llround(along * std::cos(angle) - beside * std::sin(angle)),
                             std::llround(along * std::sin(angle) + beside * std::cos(angle)), std::llround(height),
                             400});
    };
    at(-4000, -1500, 1500);
    at(14000, -1500, -9000);
    model.ends.push_back({static_cast<uint32_t>(2 * k), static_cast<uint32_t>(2 * k + 1)});
  }
  return model;
}

TEST(StickMapBuilder, ShowsCycles) {
  for (const int corners : {3, 4, 5, 6})
    for (const bool whole : {false, true}) {
      const StickModel model = carton(corners);
      const BuiltSticks built(model.balls, model.ends, 200, along_z, whole);
      expect_map(built, "8 ", 300);
      EXPECT_GE(built.builder().violation().second, 3U) << built.violation();
      EXPECT_EQ(built.builder().map().perturbation, 0);
      EXPECT_EQ(sticks_disagree(BuiltSticks(model.balls, model.ends, 200, {1, 0, 0}, whole), 200), "");
    }
}

// Two of one direction and two across, woven: halves would have an order.
TEST(StickMapBuilder, ShowsWovenSticks) {
  const Balls balls = {{-9000, -2000, 700, 500}, {9000, -2000, -700, 500},  {-9000, 2000, -700, 500},
                       {9000, 2000, 700, 500},   {-2000, -9000, -700, 500}, {-2000, 9000, 700, 500},
                       {2000, -9000, 700, 500},  {2000, 9000, -700, 500}};
  for (const double radius : {50.0, 90.0})
    expect_map(BuiltSticks(balls, {{0, 1}, {2, 3}, {4, 5}, {6, 7}}, radius, along_z, true), "8 ", 300);
}

class RegionsOfMolecule : public testing::TestWithParam<const char *> {};

// From balls that meet here and there to the van der Waals surface, which hides most sticks.
TEST_P(RegionsOfMolecule, ShowWhatIsVisible) {
  const Balls atoms = read_molecule(support::own_molecule(GetParam()));
  const int count = atoms.size() > 100 ? 2 : 40;
  for (int k = 0; k < count; ++k)
    for (const double part : {0.37, 0.5, 1.0}) {
      const StickModel model = sticks_between_close(atoms, part);
      const BuiltSticks built(model.balls, model.ends, 150, one_of(k, count), k % 2 == 1);
      if (built.status() == hsp::Status::conflict) {
        ADD_FAILURE() << part << " " << built.violation();
        continue;
      }
      EXPECT_EQ(sticks_disagree(built, atoms.size() > 100 ? 200 : 100), "") << k << " " << part;
      EXPECT_EQ(built.builder().map().perturbation, 0) << k << " " << part;
    }
}

INSTANTIATE_TEST_SUITE_P(Molecules, RegionsOfMolecule, testing::Values("caffeine.pdb", "crambin.pdb"));

// A ball in the middle, and others around it that may meet it and each other, with sticks to some.
TEST(StickMapBuilder, ShowsBallsThatMeet) {
  oracle::RandomSource random(51);
  int drawn = 0, with_sticks = 0;
  for (int time = 0; time < 250; ++time) {
    StickModel model{{{0, 0, 0, 500}}, {}};
    const size_t n = 1 + random.below(5);
    while (model.balls.size() <= n) {
      model.balls.push_back(oracle::ball_in_box(random, 1300, 200, 600));
      const auto last = static_cast<uint32_t>(model.balls.size() - 1);
      if (random.below(3) == 0) continue;
      if (random.below(2) == 0)
        model.ends.push_back({0, last});
      else
        model.ends.push_back({last, 0});
    }
    const BuiltSticks built(model.balls, model.ends, 20.0 + static_cast<double>(random.below(100)));
    if (built.status() == hsp::Status::conflict) continue;
    ++drawn;
    for (const hsp::StickPath &path : built.view().paths.items()) with_sticks += path.stick != hsp::no_id ? 1 : 0;
    ASSERT_EQ(sticks_disagree(built, 100), "") << time << oracle::to_text(model.balls);
  }
  EXPECT_GT(drawn, 100);
  EXPECT_GT(with_sticks, 100);
}

TEST(StickMapBuilder, ShowsBallsInsideOthersAndTwice) {
  const auto expect_shown = [](const Balls &balls, const Ends &ends) {
    EXPECT_EQ(sticks_disagree(BuiltSticks(balls, ends, 1), 100), "") << oracle::to_text(balls);
  };
  expect_shown({{0, 0, 0, 50}, {0, 0, 0, 50}, {5, 0, 7, 20}, {30, 0, 0, 50}}, {});
  expect_shown({{0, 0, 0, 50}, {0, 0, 0, 50}}, {{0, 1}});
  expect_shown({{0, 0, 0, 50}, {0, 0, 0, 20}}, {{0, 1}});
  // Touching from inside and from outside.
  expect_shown({{0, 0, 0, 50}, {30, 0, 0, 20}, {100, 0, 0, 50}, {60, 60, 0, 40}}, {});
}

// A stick that is just as long as its balls are in each other: when they are moved it may look out, into a third ball.
TEST(StickMapBuilder, LeavesOutWhatWasInside) {
  Balls balls;
  for (int i = 0; i < 27; ++i) balls.push_back({4000 * (i % 3), 4000 * (i / 3 % 3), 4000 * (i / 9), 3000});
  const BuiltSticks built(balls, {{4, 10}}, 1000);
  EXPECT_EQ(built.status(), hsp::Status::ok) << built.violation();
  EXPECT_GT(built.builder().map().perturbation, 0);
  EXPECT_EQ(sticks_disagree(built, 100), "");
}

// All balls at one height, or all in one column: half circles are seen edge on, contours coincide.
TEST(StickMapBuilder, ShowsPlaneGroupsAlongAxes) {
  Balls balls;
  Ends ends;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const auto k = static_cast<uint32_t>(balls.size());
      balls.push_back({1000 * i, 1000 * j, 0, 400});
      if (i > 0) ends.push_back({k, k - 3});
      if (j > 0) ends.push_back({k - 1, k});
    }
  balls.push_back({500, 500, -900, 700});
  balls.push_back({500, 500, 900, 300});
  balls.push_back({500, 500, 1300, 300});
  for (const Direction &towards : {along_z, Direction{1, 0, 0}, Direction{0, 1, 0}, Direction{1, 1, 0},
                                   Direction{1, 1, 1}, Direction{0, 0, -1}, Direction{0, 1, 2}})
    expect_map(BuiltSticks(balls, ends, 100, towards), "1 ", 200);
}

// Hundreds of level sticks, one behind the other: once moved, all of them are nearly level.
TEST(StickMapBuilder, FindsLatticesOfSticksAlongTheirAxes) {
  StickModel model{oracle::box_lattice({6, 6, 6}, {1000, 1000, 1000}, 300), {}};
  for (uint32_t i = 0; i < model.balls.size(); ++i)
    for (const uint32_t step : {1U, 6U, 36U})
      if (i / step % 6 > 0) model.ends.push_back({i, i - step});
  for (const Direction &towards : {along_z, Direction{0, -1, 0}, Direction{1, 1, 1}}) {
    const BuiltSticks built(model.balls, model.ends, 90, towards, false, true);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    EXPECT_LT(built.builder().map().perturbation, 0.01);
  }
}

TEST(StickMapBuilder, TellsTheLimitsThatSuffice) {
  const StickModel model = carton(4);
  BuiltSticks built(model.balls, model.ends, 200);
  const hsp::StickLimits needed = built.builder().needed();
  EXPECT_GT(needed.edges, 40U);
  built.take(needed);
  EXPECT_EQ(built.build(along_z), hsp::Status::ok);
  for (const uint32_t edges : {0U, 1U, needed.edges / 2, needed.edges - 1}) {
    hsp::StickLimits less = needed;
    less.edges = edges;
    built.take(less);
    EXPECT_EQ(built.build(along_z), hsp::Status::capacity);
    EXPECT_FALSE(built.builder().map().exist);
    EXPECT_GT(built.builder().retry_limits().edges, edges);
  }
  built.look({1, 0, 0});
  EXPECT_EQ(built.status(), hsp::Status::ok);
  EXPECT_FALSE(built.builder().map().exist);
  EXPECT_EQ(built.builder().needed().edges, 0U);
}

// A crease that goes behind a ball at the height of its centre, where roundings may find it neither on the ball's front
// nor on its contour.
TEST(StickMapBuilder, NoticesWhatBeginsToBeHiddenAtTheHeightOfACentre) {
  const SeenSet set{{{0, 0, 0, 3}, {-1, 2, -2, 0}, {-5, 2, -5, 5}, {-7, -1, -4, 7}}, {0, 1, 0}};
  EXPECT_EQ(set_complaint(set, 300), "");
}

}  // namespace
