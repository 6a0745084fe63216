// Places of few keys against a sort.
#include "core/key_ranks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "random_numbers.hpp"
#include "runnable_targets.hpp"

namespace {

void check(hsp::Target target) {
  support::RandomNumbers<support::SplitMix64> random(7);
  for (int round = 0; round < 20000; ++round) {
    const uint32_t count = static_cast<uint32_t>(random.in(0, hsp::most_counted_keys));
    // Few values, so that some are equal; or all there are.
    const int64_t largest = round % 2 == 0 ? static_cast<int64_t>(count) : std::numeric_limits<int64_t>::max() / 2;
    int64_t key[hsp::most_counted_keys];
    for (int64_t &k : key) k = 2 * random.in(-largest, largest);
    if (count > 2) key[1] = std::numeric_limits<int64_t>::min();
    uint32_t rank[hsp::most_counted_keys];
    hsp::count_ranks(target, key, count, rank);
    std::vector<int64_t> sorted(key, key + count);
    std::sort(sorted.begin(), sorted.end());
    for (uint32_t k = 0; k < count; ++k) {
      ASSERT_EQ(rank[k], std::lower_bound(sorted.begin(), sorted.end(), key[k]) - sorted.begin());
    }
  }
}

TEST(KeyRanks, AreThoseOfASort) {
  for (const hsp::Target target : runnable_targets()) check(target);
}

}  // namespace
