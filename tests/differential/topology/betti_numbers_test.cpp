// Components, handles and voids of every single component against the exact nerve, and the invariants of topologies, on
// random degenerate sets in several orders.
#include <gtest/gtest.h>

#include "cell_comparison.hpp"
#include "nerve.hpp"
#include "random_balls.hpp"
#include "smallest_failing.hpp"
#include "sweep_length.hpp"
#include "topology_complaints.hpp"

namespace {

using oracle::Balls;

std::string betti_numbers_or_invariants(const Balls &balls) {
  const std::string complaint = betti_numbers_disagree(balls, 2, 41);
  return complaint.empty() ? topology_invariant_broken(balls) : complaint;
}

TEST(BettiNumbers, OfDegenerateSets) {
  oracle::RandomSource random(42);
  std::array<int, 3> seen = {0, 0, 0};
  for (int k = 0; k < oracle::sets(10000); ++k) {
    const Balls balls = oracle::degenerate_balls(random, static_cast<size_t>(random.in(1, 9)));
    ASSERT_EQ(complaint_about_smallest(balls, betti_numbers_or_invariants), "");
    const std::array<int64_t, 3> betti = oracle::nerve_betti_numbers(balls);
    for (size_t d = 0; d < 3; ++d) seen[d] += betti[d] > (d == 0 ? 1 : 0) ? 1 : 0;
  }
  EXPECT_GT(seen[0], oracle::sets(1000));
  EXPECT_GT(seen[1], oracle::sets(200));
  if (oracle::sets_for_one == 1) {
    EXPECT_GT(seen[2], 0);
  }
}

TEST(BettiNumbers, OfCrownedBalls) {
  oracle::RandomSource random(43);
  for (int k = 0; k < oracle::sets(200); ++k) {
    const Balls balls = oracle::crowned_balls(random, static_cast<size_t>(random.in(9, 26)));
    ASSERT_EQ(complaint_about_smallest(balls, betti_numbers_or_invariants), "");
  }
}

TEST(BettiNumbers, OfBoxesThatNearlyClose) {
  oracle::RandomSource random(44);
  for (int k = 0; k < oracle::sets(300); ++k) {
    Balls balls;
    for (int64_t corner = 0; corner < 8; ++corner)
      balls.push_back({4 * (corner & 1), 6 * (corner >> 1 & 1), 12 * (corner >> 2), random.in(6, 7)});
    if (random.one_in(2)) balls.push_back({2, 3, 6, random.in(0, 1)});
    ASSERT_EQ(complaint_about_smallest(balls, betti_numbers_or_invariants), "");
  }
}

TEST(Invariants, OfAnySets) {
  oracle::RandomSource random(45);
  for (int k = 0; k < oracle::sets(1500); ++k) {
    const Balls balls = oracle::any_balls(random, static_cast<size_t>(random.in(5, 40)));
    ASSERT_EQ(complaint_about_smallest(balls, topology_invariant_broken), "");
  }
}

TEST(Invariants, OrdersOfAnySets) {
  oracle::RandomSource random(46);
  for (int k = 0; k < oracle::sets(1000); ++k) {
    const Balls balls = oracle::any_balls(random, static_cast<size_t>(random.in(3, 30)));
    ASSERT_EQ(complaint_about_smallest(balls, topology_orders_disagree), "");
  }
}

// Where several cut arcs end on one arc or circle its pieces share its angle; and on a circle without radius, where
// two balls touch, positions do not tell how.
TEST(Invariants, AnglesInAnyOrder) {
  for (const Balls &balls :
       {Balls{{1, 1, 0, 1}, {0, 0, 0, 2}, {1, 2, 2, 1}}, Balls{{0, 6, 0, 6}, {4, 0, 0, 6}, {4, 0, 12, 6}},
        Balls{{0, 0, 0, 70}, {30, 20, 60, 7}, {60, 30, 20, 7}}})
    EXPECT_EQ(topology_orders_disagree(balls), "");
  oracle::RandomSource random(47);
  for (int k = 0; k < oracle::sets(300); ++k) {
    const Balls balls = oracle::any_balls(random, static_cast<size_t>(random.in(3, 30)));
    ASSERT_EQ(complaint_about_smallest(balls, topology_orders_disagree), "");
  }
}

}  // namespace
