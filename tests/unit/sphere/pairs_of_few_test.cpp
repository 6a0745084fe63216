// Pairs of a few things in one word: against loops over the things, and sets against a search from thing to thing.
#include <gtest/gtest.h>

#include "random_balls.hpp"

#if HSP_LANES
#include "sphere/pairs_of_few.hpp"

namespace {

using hsp::pairs_of_few;
using hsp::PairsOfFew;

TEST(PairsOfFew, AreAllInOrder) {
  for (uint32_t things = 2; things <= PairsOfFew::most; ++things) {
    uint32_t p = 0;
    for (uint32_t j = 0; j < things; ++j) {
      for (uint32_t k = j + 1; k < things; ++k, ++p) {
        ASSERT_EQ(pairs_of_few.j[things][p], j);
        ASSERT_EQ(pairs_of_few.k[things][p], k);
      }
    }
    ASSERT_EQ(hsp::count_of_pairs(things), p);
  }
}

TEST(PairsOfFew, ThingsAndSets) {
  oracle::RandomSource random(1);
  uint32_t in_one_set = 0;
  for (int turn = 0; turn < 4000; ++turn) {
    const auto things = static_cast<uint32_t>(random.in(1, PairsOfFew::most));
    const uint32_t count = hsp::count_of_pairs(things);
    // Few of them, so that there are several sets.
    const auto some = [&] {
      uint32_t bits = 0;
      for (uint32_t p = 0; p < count; ++p) bits |= (random.in(0, things) == 0 ? 1U : 0U) << p;
      return bits;
    };
    const uint32_t pairs = some(), others = some();
    uint32_t in = 0, set_of[PairsOfFew::most];
    for (uint32_t t = 0; t < things; ++t) set_of[t] = t;
    for (uint32_t p = 0; p < count; ++p) {
      const uint32_t j = pairs_of_few.j[things][p], k = pairs_of_few.k[things][p];
      in |= (pairs >> p & 1U) << j | (others >> p & 1U) << k;
      if ((pairs >> p & 1U) == 0) continue;
      const uint32_t from = set_of[j], to = set_of[k];
      for (uint32_t t = 0; t < things; ++t) set_of[t] = set_of[t] == from ? to : set_of[t];
    }
    uint32_t sets = 0;
    for (uint32_t t = 0; t < things; ++t) {
      bool is_first = true;
      for (uint32_t s = 0; s < t; ++s) is_first = is_first && set_of[s] != set_of[t];
      sets += is_first ? 1 : 0;
    }
    ASSERT_EQ(hsp::things_in(things, pairs, others), in);
    ASSERT_EQ(hsp::connected_sets(hsp::matrix_of(things, pairs), things), sets);
    in_one_set += sets == 1 && things > 4 ? 1 : 0;
  }
  EXPECT_GT(in_one_set, 20U);
}

}  // namespace
#endif
