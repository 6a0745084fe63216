// Ranks and members of sets of numbers, against a list.
#include "core/ranked_bits.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "random_numbers.hpp"

namespace {

class Ranked {
 public:
  explicit Ranked(uint64_t most) {
    hsp::Workspace measured;
    bits.carve(measured, most);
    memory_.resize(measured.bytes());
    hsp::Workspace workspace(memory_.data(), memory_.size());
    bits.carve(workspace, most);
  }
  hsp::RankedBits bits;

 private:
  std::vector<unsigned char> memory_;
};

TEST(RankedBits, AsAList) {
  support::Random random(5);
  for (const uint32_t n : {0U, 1U, 63U, 64U, 65U, 128U, 1000U}) {
    for (const uint32_t one_in : {1U, 2U, 40U}) {
      Ranked ranked(n);
      std::vector<uint32_t> members;
      ranked.bits.clear(n);
      for (uint32_t k = 0; k < n; ++k) {
        if (random.below(one_in) != 0) continue;
        ranked.bits.set(k);
        members.push_back(k);
      }
      ranked.bits.count();
      ASSERT_EQ(ranked.bits.size(), members.size());
      uint32_t rank = 0;
      for (uint32_t k = 0; k < n; ++k) {
        const bool has = rank < members.size() && members[rank] == k;
        ASSERT_EQ(ranked.bits.rank(k), rank);
        ASSERT_EQ(ranked.bits.has(k), has);
        if (!has) continue;
        ASSERT_EQ(ranked.bits.member(rank), k);
        ++rank;
      }
    }
  }
}

TEST(RankedBits, CanBeUsedAgain) {
  Ranked ranked(200);
  ranked.bits.clear(200);
  for (uint32_t k = 0; k < 200; ++k) ranked.bits.set(k);
  ranked.bits.count();
  EXPECT_EQ(ranked.bits.size(), 200U);
  ranked.bits.clear(70);
  ranked.bits.set(69);
  ranked.bits.count();
  EXPECT_EQ(ranked.bits.size(), 1U);
  EXPECT_EQ(ranked.bits.member(0), 69U);
}

}  // namespace
