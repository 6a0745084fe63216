// The comparisons of the other files of this folder over many more sets.
#include <gtest/gtest.h>

#include "checked_passage.hpp"
#include "checked_pores.hpp"
#include "molecule_balls.hpp"
#include "pore_widths.hpp"
#include "sweep_length.hpp"

namespace {

TEST(PoresSlow, AllSetsOfThreeAndFour) {
  oracle::RandomSource random(11);
  checked_pores::Seen seen;
  for (int turn = 0; turn < oracle::rounds(300, 5000); ++turn) {
    const auto n = static_cast<size_t>(random.in(3, 16));
    ASSERT_NO_FATAL_FAILURE(
        checked_pores::compare_with_all_sets(pore_sets::general_set(random, n, turn % pore_sets::general_kinds), seen));
    ASSERT_NO_FATAL_FAILURE(
        checked_pores::compare_with_all_sets(pore_sets::tied_set(random, n, turn % pore_sets::tied_kinds), seen));
  }
}

TEST(PoresSlow, EulerSumsOfTiedSets) {
  oracle::RandomSource random(12);
  checked_pores::Seen seen;
  for (int turn = 0; turn < oracle::rounds(600, 10000); ++turn) {
    const oracle::Balls balls =
        pore_sets::tied_set(random, static_cast<size_t>(random.in(1, 16)), turn % pore_sets::tied_kinds);
    ASSERT_NO_FATAL_FAILURE(checked_pores::check_euler_sum(balls, seen));
  }
}

TEST(PoresSlow, Cages) {
  oracle::RandomSource random(13);
  checked_pores::Seen seen;
  for (int turn = 0; turn < oracle::rounds(1, 2); ++turn) {
    for (int kind = 0; kind < pore_sets::cage_kinds; ++kind) {
      for (const double unit : {1e8, 1e7, 1e6, 1e5, 1e4, 1e3}) {
        const oracle::Balls balls = pore_sets::cage(random, kind, unit);
        ASSERT_NO_FATAL_FAILURE(checked_pores::check_euler_sum(balls, seen));
        ASSERT_NO_FATAL_FAILURE(checked_pores::compare_with_regions(balls, seen));
      }
    }
  }
}

TEST(PoresSlow, ComponentsAtAllLevels) {
  oracle::RandomSource random(14);
  checked_pores::Seen seen;
  for (int turn = 0; turn < oracle::rounds(300, 1200); ++turn) {
    const auto n = static_cast<size_t>(random.in(1, 30));
    const oracle::Balls balls = turn % 2 == 0 ? pore_sets::tied_set(random, n, turn / 2 % pore_sets::tied_kinds)
                                              : pore_sets::general_set(random, n, turn / 2 % pore_sets::general_kinds);
    ASSERT_NO_FATAL_FAILURE(checked_pores::compare_with_regions(balls, seen));
  }
}

TEST(PoresSlow, WidestProbesBetweenPlaces) {
  oracle::RandomSource random(15);
  pore_widths::Seen seen;
  for (int turn = 0; turn < oracle::rounds(120, 12500); ++turn) {
    ASSERT_NO_FATAL_FAILURE(pore_widths::compare_with_gates(random, turn % pore_sets::general_kinds, 8, seen));
  }
}

TEST(PoresSlow, WidestProbesAmongRandomBalls) {
  oracle::RandomSource random(16);
  checked_passage::Seen seen;
  ASSERT_NO_FATAL_FAILURE(checked_passage::check_among_random_balls(random, oracle::rounds(20, 300), seen));
  EXPECT_GT(seen.gates, 0U);
  EXPECT_GT(seen.touches, 0U);
}

// From the void that crambin has for a probe of 1.4, with van der Waals radii: known to ten digits, by a search among
// power diagrams in doubles.
TEST(PoresSlow, WidestProbeOutOfCrambin) {
  using namespace checked_passage;
  Balls balls = read_molecule(support::own_molecule("crambin.pdb"));
  for (auto &ball : balls) ball = {ball.x * 100000, ball.y * 100000, ball.z * 100000, ball.radius * 100000};
  const Balls accessible = grown(balls, 140000000);
  BuiltTopology topology(accessible);
  ASSERT_EQ(topology.status(), hsp::Status::ok);
  ASSERT_EQ(topology.structure().region_count, 2U);
  const Vector from{980000000, 1220000000, 610000000};
  ASSERT_GT(room(accessible, from), 0.0);
  ASSERT_NE(cell_of(topology, from), 0U);
  const BuiltPassage built(balls, from, nullptr);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  EXPECT_NEAR(built.level() * 1e-8, 0.838840049, 6e-10);
  EXPECT_TRUE(built.has_gate());
}

}  // namespace
