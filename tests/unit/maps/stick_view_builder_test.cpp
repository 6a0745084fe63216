// Pictures of balls and sticks against the z-buffer of balls and cylinders: no pixel differs.
#include "maps/stick_view_builder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "built_sticks.hpp"
#include "molecule_balls.hpp"
#include "random_balls.hpp"

namespace {

using Direction = std::array<double, 3>;
using Ends = std::vector<BuiltSticks::Ends>;
using oracle::Balls;

constexpr Direction along_z{0, 0, 1};
const std::vector<hsp::StickStrands> kinds = {hsp::StickStrands::two, hsp::StickStrands::dashed, hsp::StickStrands::one,
                                              hsp::StickStrands::three};

constexpr Direction directions[] = {along_z, {0, 1, 0}, {1, 1, 1}, {0.37, -0.61, 0.83}};

double distance(const oracle::LatticeBall &a, const oracle::LatticeBall &b) {
  return std::hypot(static_cast<double>(a.x - b.x), static_cast<double>(a.y - b.y), static_cast<double>(a.z - b.z));
}

class SticksOfMolecule : public testing::TestWithParam<const char *> {};

TEST_P(SticksOfMolecule, ShowWhatIsVisible) {
  const StickModel model = sticks_between_close(read_molecule(support::own_molecule(GetParam())), 0.25);
  ASSERT_GT(model.ends.size() + 2, model.balls.size());
  for (const Direction &towards : directions)
    for (const bool whole : {false, true}) {
      const BuiltSticks built(model.balls, model.ends, 120, towards, whole);
      EXPECT_EQ(sticks_disagree(built, 300), "") << towards[0];
      const BuiltSticks several(model.balls, model.ends, 120, towards, whole, false, kinds);
      EXPECT_FALSE(several.builder().map().exist);
      EXPECT_EQ(sticks_disagree(several, 300), "") << towards[0];
    }
  const BuiltSticks as_map(model.balls, model.ends, 120, along_z, false, true);
  EXPECT_TRUE(as_map.builder().map().exist);
  EXPECT_EQ(sticks_disagree(as_map, 300), "");
}

INSTANTIATE_TEST_SUITE_P(Molecules, SticksOfMolecule, testing::Values("caffeine.pdb", "acetyl_coa.pdb", "crambin.pdb"));

// Stars of sticks around a ball in the middle: what leaves it steeply and flatly, to and from the viewer.
TEST(StickViewBuilder, ShowsStars) {
  oracle::RandomSource random(31);
  int drawn = 0, refused = 0;
  for (int time = 0; time < 300; ++time) {
    StickModel model{{{0, 0, 0, 400}}, {}};
    const size_t n = 1 + random.below(6);
    while (model.balls.size() <= n) {
      const oracle::LatticeBall ball = oracle::ball_in_box(random, 1500, 200, 500);
      if (distance(ball, model.balls[0]) < 1000) continue;
      model.balls.push_back(ball);
      const auto last = static_cast<uint32_t>(model.balls.size() - 1);
      if (random.below(2) == 0)
        model.ends.push_back({0, last});
      else
        model.ends.push_back({last, 0});
    }
    const BuiltSticks built(model.balls, model.ends, 20.0 + static_cast<double>(random.below(170)));
    if (built.status() == hsp::Status::ok) {
      ++drawn;
      ASSERT_EQ(sticks_disagree(built, 150), "") << time << oracle::to_text(model.balls);
      const BuiltSticks as_map(model.balls, model.ends, built.radius(), along_z, time % 2 == 0, true);
      ASSERT_EQ(sticks_disagree(as_map, 100), "") << time << oracle::to_text(model.balls);
      for (const bool map : {false, true}) {
        const BuiltSticks several(model.balls, model.ends, built.radius() / 1.5, along_z, time % 2 == 0, map, kinds);
        ASSERT_EQ(sticks_disagree(several, 150), "") << time << oracle::to_text(model.balls);
      }
    } else {
      ++refused;
      ASSERT_EQ(built.status(), hsp::Status::conflict);
    }
  }
  EXPECT_GT(drawn, 50);
  EXPECT_GT(refused, 50);
}

// Heaps of sticks apart from each other. Some are refused, among them cycles.
TEST(StickViewBuilder, ShowsHeaps) {
  oracle::RandomSource random(32);
  int drawn = 0;
  std::array<int, 9> refused{};
  for (int time = 0; time < 300; ++time) {
    StickModel model;
    const size_t n = 2 + random.below(12);
    for (uint32_t k = 0; k < n; ++k) {
      model.balls.push_back(oracle::ball_in_box(random, 4000, 150, 300));
      model.balls.push_back(oracle::ball_in_box(random, 4000, 150, 300));
      model.ends.push_back({2 * k, 2 * k + 1});
    }
    const Direction towards = directions[random.below(4)];
    const BuiltSticks built(model.balls, model.ends, 100, towards);
    const BuiltSticks several(model.balls, model.ends, 100 / 1.5, towards, false, false, kinds);
    if (several.status() == hsp::Status::ok) {
      ASSERT_EQ(sticks_disagree(several, 150), "") << time << oracle::to_text(model.balls);
    }
    if (built.status() == hsp::Status::ok) {
      ++drawn;
      ASSERT_EQ(sticks_disagree(built, 150), "") << time << oracle::to_text(model.balls);
    } else {
      ++refused[static_cast<size_t>(built.builder().violation().conflict)];
      ASSERT_EQ(built.status(), hsp::Status::conflict);
    }
  }
  EXPECT_GT(drawn, 50);
  EXPECT_GT(refused[static_cast<size_t>(hsp::StickConflict::sticks_meet)], 5);
  EXPECT_GT(refused[static_cast<size_t>(hsp::StickConflict::stick_in_ball)], 5);
}

// In the plane of the picture, straight at the viewer, and behind a ball.
TEST(StickViewBuilder, ShowsSticksAlongAxes) {
  const Balls balls = {{0, 0, 0, 400},     {2000, 0, 0, 300},  {0, 2000, 0, 300}, {0, 0, 2000, 300},
                       {-2000, 0, 0, 300}, {0, -2000, 0, 300}, {0, 0, -2000, 500}};
  const Ends ends = {{0, 1}, {2, 0}, {0, 3}, {4, 0}, {0, 5}, {6, 0}};
  for (const Direction &towards : {along_z, Direction{1, 0, 0}, Direction{0, -1, 0}, Direction{1, 1, 0},
                                   Direction{1, 1, 1}, Direction{1e-9, 0, 1}, Direction{1, 0, 20}, Direction{1, 30, 0}})
    EXPECT_EQ(sticks_disagree(BuiltSticks(balls, ends, 150, towards), 200), "") << towards[0] << " " << towards[1];
}

TEST(StickViewBuilder, ShowsBallsAlone) {
  EXPECT_EQ(sticks_disagree(BuiltSticks({{0, 0, 0, 10}, {0, 30, 0, 20}, {7, 9, 80, 13}, {1, 2, 3, 0}}, {}, 1), 100),
            "");
  EXPECT_EQ(BuiltSticks({}, {}, 1).status(), hsp::Status::ok);
}

TEST(StickViewBuilder, NamesWhatItRefuses) {
  const auto refusal = [](const Balls &balls, const Ends &ends, double radius) {
    const BuiltSticks built(balls, ends, radius);
    EXPECT_EQ(built.status(), hsp::Status::conflict);
    EXPECT_EQ(built.view().paths.size(), 0U);
    return built.violation();
  };
  const Balls far_apart = {{0, 0, 0, 10}, {100, 0, 0, 10}, {0, 100, 0, 10}, {100, 100, 5, 10}};
  EXPECT_EQ(refusal(far_apart, {{0, 1}, {2, 4}}, 1), "2 1 4");
  EXPECT_EQ(refusal(far_apart, {{7, 1}}, 1), "2 0 7");
  EXPECT_EQ(refusal(far_apart, {{0, 1}, {3, 3}}, 1), "3 1 1");
  EXPECT_EQ(refusal(far_apart, {{0, 1}, {2, 3}, {1, 0}}, 1), "3 0 2");
  EXPECT_EQ(refusal(far_apart, {{0, 1}}, 10), "4 0 0");
  EXPECT_EQ(refusal({{0, 0, 0, 10}, {100, 0, 0, 5}}, {{0, 1}}, 6), "4 0 1");
  // 45 degrees and 60 degrees: at least 2.61 and 2 times as thick.
  EXPECT_EQ(refusal(far_apart, {{0, 1}, {0, 3}}, 4), "5 0 1");
  const Ends bent = {{0, 1}, {2, 0}};
  EXPECT_EQ(refusal({{0, 0, 0, 1999}, {10000, 0, 0, 1010}, {5000, 8660, 0, 1010}}, bent, 1000), "5 0 1");
  EXPECT_EQ(BuiltSticks({{0, 0, 0, 2001}, {10000, 0, 0, 1010}, {5000, 8660, 0, 1010}}, bent, 1000).status(),
            hsp::Status::ok);
  // The thicker one of two decides.
  const std::vector<hsp::StickStrands> unequal = {hsp::StickStrands::one, hsp::StickStrands::two};
  for (const int64_t thick : {1999, 2001}) {
    const BuiltSticks built({{0, 0, 0, thick}, {10000, 0, 0, 1010}, {5000, 8660, 0, 1010}}, bent, 2000.0 / 3, along_z,
                            false, false, unequal);
    EXPECT_EQ(built.violation(), thick < 2000 ? "5 0 1" : "0 4294967295 4294967295");
  }
  EXPECT_EQ(refusal(far_apart, {{0, 3}, {1, 2}}, 3), "6 0 1");
  EXPECT_EQ(BuiltSticks(far_apart, {{0, 3}, {1, 2}}, 1.2).status(), hsp::Status::ok);
  EXPECT_EQ(refusal({{0, 0, 0, 10}, {100, 0, 0, 10}, {50, 0, 12, 10}}, {{0, 1}}, 3), "7 0 2");
  EXPECT_EQ(BuiltSticks({{0, 0, 0, 10}, {100, 0, 0, 10}, {50, 0, 14, 10}}, {{0, 1}}, 3).status(), hsp::Status::ok);
}

TEST(StickViewBuilder, TellsTheLimitsThatSuffice) {
  const StickModel model = sticks_between_close(read_molecule(support::own_molecule("caffeine.pdb")), 0.25);
  BuiltSticks built(model.balls, model.ends, 120, directions[3]);
  const hsp::StickLimits needed = built.builder().needed();
  EXPECT_EQ(needed.balls, model.balls.size());
  EXPECT_EQ(needed.sticks, model.ends.size());
  built.take(needed);
  EXPECT_EQ(built.build(directions[3]), hsp::Status::ok);
  for (const auto limit : {&hsp::StickLimits::balls, &hsp::StickLimits::sticks, &hsp::StickLimits::pairs}) {
    hsp::StickLimits less = needed;
    --(less.*limit);
    built.take(less);
    EXPECT_EQ(built.build(directions[3]), hsp::Status::capacity);
    EXPECT_EQ(built.builder().retry_limits().*limit, needed.*limit);
  }
  hsp::StickLimits defaults;
  ASSERT_EQ(hsp::default_limits(static_cast<uint32_t>(model.balls.size()), defaults), hsp::Status::ok);
  built.take(defaults);
  EXPECT_EQ(built.build(directions[3]), hsp::Status::ok);
  EXPECT_EQ(hsp::default_limits(hsp::max_count, defaults), hsp::Status::range);
}

TEST(StickViewBuilder, RefusesDirectionsThatAreNone) {
  BuiltSticks built({{0, 0, 0, 5}}, {}, 1);
  built.look({std::numeric_limits<double>::infinity(), 0, 1});
  EXPECT_EQ(built.status(), hsp::Status::not_finite);
}

}  // namespace
