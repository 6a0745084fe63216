// The comparison of this folder on many more sets.
#include <gtest/gtest.h>

#include "brick_comparison.hpp"
#include "sweep_length.hpp"

namespace {

TEST(Slow, SameBitsAsOnePiece) {
  BrickComparison comparison;
  for (int k = 0; k < oracle::rounds(2000, 32000); ++k) {
    support::Random random(UINT64_C(77) << 32 | static_cast<uint64_t>(k));
    const BrickSet set = random_brick_set(random);
    ASSERT_EQ(comparison.complaint(set, random, 4), "") << "set " << k << ", " << set.balls.size() << " balls";
  }
}

}  // namespace
