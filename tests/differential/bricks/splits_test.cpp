// Random and degenerate sets in random bricks, with least halos and wider ones, merged in random trees, against one
// piece, bit for bit, and that against boundary and topology.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "brick_comparison.hpp"
#include "sweep_length.hpp"

namespace {

void expect_no_difference(uint64_t seed, int sets) {
  BrickComparison comparison;
  for (int k = 0; k < sets; ++k) {
    support::Random random(seed * UINT64_C(1000003) + static_cast<uint64_t>(k));
    const BrickSet set = random_brick_set(random);
    ASSERT_EQ(comparison.complaint(set, random, 4), "")
        << "set " << k << " of seed " << seed << ", " << set.balls.size() << " balls";
  }
  const BrickComparison::Counters &counters = comparison.counters();
  std::printf("%llu sets, %llu splits, %llu bricks, %llu merges, %llu faults refused; %llu voids, %llu tied vertices\n",
              static_cast<unsigned long long>(counters.sets), static_cast<unsigned long long>(counters.splits),
              static_cast<unsigned long long>(counters.bricks), static_cast<unsigned long long>(counters.merges),
              static_cast<unsigned long long>(counters.refused), static_cast<unsigned long long>(counters.voids),
              static_cast<unsigned long long>(counters.tied));
}

TEST(Splits, SameBitsAsOnePiece) {
  expect_no_difference(1, oracle::sets(200));
}

// So many sets, and a seed, as HSP_BRICK_SETS says; by hand.
TEST(Splits, AsManyAsAreAskedFor) {
  const char *const asked = std::getenv("HSP_BRICK_SETS");
  int sets = 0;
  unsigned long long seed = 1;
  if (asked != nullptr && std::sscanf(asked, "%d,%llu", &sets, &seed) > 0) expect_no_difference(seed, sets);
}

}  // namespace
