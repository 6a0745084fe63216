// Sums by several tasks have the bits of one sum.
#include "measure/sums_in_parts.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <vector>

#include "core/summation.hpp"
#include "random_numbers.hpp"

namespace {

struct OneSum {
  using Term = double;
  void add(double term) { sum.add(term); }
  double sums(double rest) const { return sum.total(rest); }
  hsp::TreeSum sum;
};

bool last_first(void *, uint32_t tasks, hsp::Executor::Task *task, void *data) {
  while (tasks-- > 0) task(data, tasks);
  return true;
}
bool none(void *, uint32_t, hsp::Executor::Task *, void *) {
  return true;
}

TEST(SumsInParts, HaveTheBitsOfOneSum) {
  support::Random random(9);
  for (const uint32_t n : {0U, 1U, 63U, 64U, 65U, 128U, 200U, 1000U, 4096U, 5000U}) {
    std::vector<double> terms(n);
    for (double &term : terms) term = (random.fraction() - 0.5) * (random.below(2) == 0 ? 1.0 : 1e9);
    hsp::TreeSum alone;
    for (const double term : terms) alone.add(term);
    for (const uint32_t workers : {1U, 2U, 3U, 7U, 40U}) {
      std::vector<int> visits(n);
      double sum = -1.0;
      const auto visit = [&](hsp::IdRange range, OneSum &own) {
        for (const uint32_t k : range) {
          own.add(terms[k]);
          ++visits[k];
        }
      };
      EXPECT_TRUE(hsp::sum_in_parts<OneSum>(hsp::Executor(workers, last_first, nullptr), n, visit, sum));
      EXPECT_EQ(std::bit_cast<uint64_t>(sum), std::bit_cast<uint64_t>(alone.total())) << n << " by " << workers;
      EXPECT_EQ(visits, std::vector<int>(n, 1));
    }
  }
}

TEST(SumsInParts, ALoopThatDoesNothingIsRefused) {
  double sum = 0.0;
  const auto visit = [](hsp::IdRange, OneSum &) {};
  EXPECT_FALSE(hsp::sum_in_parts<OneSum>(hsp::Executor(2, none, nullptr), 1000, visit, sum));
}

// Parts follow each other, none is longer than another, and together they are the range.
TEST(SumsInParts, WhereTheCallerMayStopPartsAreTheRange) {
  const hsp::Executor executor(1, nullptr, nullptr, [](void *) { return true; });
  for (const uint32_t size : {0U, 1U, 31U, 32U, 33U, 64U, 100U}) {
    uint32_t next = 5, calls = 0;
    hsp::visit_patiently(executor, hsp::IdRange{5, 5 + size}, [&](hsp::IdRange part) {
      EXPECT_EQ(part.first, next);
      ASSERT_GT(part.last, part.first);
      ASSERT_LT(++calls, 100U);
      next = part.last;
    });
    EXPECT_EQ(next, 5 + size);
    EXPECT_EQ(calls, (size + 31) / 32);
  }
}

}  // namespace
