#include "core/patience.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "core/id_range.hpp"

namespace {

using hsp::Executor;
using hsp::Patience;

// Goes on until it was asked as often as it has to say so.
struct Asked {
  int times = 0;
  int most = 1000000;
};
bool goes_on(void *context) {
  Asked &asked = *static_cast<Asked *>(context);
  return ++asked.times <= asked.most;
}

TEST(Patience, NobodyIsAskedWhoCannotStop) {
  const Executor alone;
  Patience of_nobody, of_alone(&alone);
  for (int k = 0; k < 100; ++k) {
    EXPECT_TRUE(of_nobody.allows(UINT64_C(1) << 40));
    EXPECT_TRUE(of_alone.allows(UINT64_C(1) << 40));
  }
}

TEST(Patience, AsksAtLeastOnceForTenMillionInstructions) {
  for (const uint64_t piece : {UINT64_C(100), UINT64_C(999), UINT64_C(100000), UINT64_C(20000000)}) {
    Asked asked;
    const Executor executor(1, nullptr, &asked, goes_on);
    Patience patience(&executor);
    uint64_t spent = 0;
    int before = 0;
    for (int k = 0; k < 300000 && spent < UINT64_C(300000000); ++k) {
      spent += piece;
      EXPECT_TRUE(patience.allows(piece));
      if (asked.times > before) {
        EXPECT_LT(spent, UINT64_C(10000000) + piece);
        spent = 0;
        before = asked.times;
      }
    }
    EXPECT_GT(asked.times, 0);
  }
}

TEST(Patience, OnceStoppedNobodyIsAskedAgain) {
  Asked asked;
  asked.most = 3;
  const Executor executor(1, nullptr, &asked, goes_on);
  Patience patience(&executor), of_another_thread(&executor);
  int allowed = 0;
  while (patience.allows(2000000)) ++allowed;
  EXPECT_EQ(allowed, 3);
  EXPECT_EQ(asked.times, 4);
  EXPECT_FALSE(patience.allows(0));
  EXPECT_FALSE(of_another_thread.allows(1));
  EXPECT_FALSE(of_another_thread.allows(2000000));
  EXPECT_EQ(asked.times, 4);
  EXPECT_TRUE(executor.is_stopped());
  EXPECT_EQ(executor.failure(), hsp::Status::stopped);
  EXPECT_FALSE(executor.for_each(1, [](uint32_t) {}));
}

// Records that cost a million instructions each: three between two questions.
TEST(Patience, PartsOfARangeAreTheWholeRangeUntilItIsStopped) {
  for (int most = 0; most <= 5; ++most) {
    Asked asked;
    asked.most = most;
    const Executor executor(1, nullptr, &asked, goes_on);
    Patience patience(&executor);
    std::vector<uint32_t> visited, expected;
    hsp::in_parts(patience, hsp::IdRange{4, 15}, 1000000, [&](hsp::IdRange part) {
      EXPECT_LE(part.size(), 3U);
      for (const uint32_t k : part) visited.push_back(k);
    });
    for (uint32_t k = 4; k < 15 && k < 4 + 3 * static_cast<uint32_t>(most + 1); ++k) expected.push_back(k);
    EXPECT_EQ(visited, expected) << most;
  }
}

// Records of a range rely on what was done before.
TEST(Patience, NoRangeIsBegunBehindAStop) {
  Asked asked;
  asked.most = 0;
  const Executor executor(1, nullptr, &asked, goes_on);
  Patience patience(&executor);
  EXPECT_FALSE(patience.allows(UINT64_C(20000000)));
  for (const uint32_t records : {1U, 3U, 100U}) {
    bool visited = false;
    hsp::in_parts(patience, hsp::IdRange{0, records}, 1000000, [&](hsp::IdRange) { visited = true; });
    EXPECT_FALSE(visited) << records;
  }
}

}  // namespace
