// The journal of an update: what each ball was before, once however often it is noted, and nothing of the last update.
#include "moving/moving_records.hpp"

#include <gtest/gtest.h>

#include "carved_memory.hpp"

namespace {

constexpr uint32_t n = 5;

class Records {
 public:
  Records() {
    memory_.carve(records, n);
    records.clear(n);
    for (uint32_t i = 0; i < n; ++i) put(i, 10 * i);
  }
  // Ball i at this x, with numbers that tell one state from the next.
  void put(uint32_t i, uint32_t x) {
    records.balls.store(i, {{int64_t{x}, 2, 3}, 4, i});
    records.ball[i].faces = x + 1;
    records.parent[i] = x + 2;
  }

  hsp::MovingRecords records;

 private:
  CarvedMemory memory_;
};

TEST(MovingRecords, TheJournalHasWhatWasThereBefore) {
  Records made;
  hsp::MovingRecords &records = made.records;
  records.note_moved(3);
  made.put(3, 300);
  records.note(1);
  made.put(1, 100);
  records.list(1);
  // A second time changes nothing, but that a ball may turn out to move.
  records.note(3);
  records.note_moved(1);
  ASSERT_EQ(records.noted(), 2U);
  const uint32_t ball[2] = {3, 1};
  for (uint32_t k = 0; k < 2; ++k) {
    const hsp::JournalEntry &entry = records.entry(k);
    EXPECT_EQ(entry.ball, ball[k]);
    EXPECT_EQ(entry.placed.centre.x, 10 * ball[k]);
    EXPECT_EQ(entry.before.faces, 10 * ball[k] + 1);
    EXPECT_EQ(entry.parent, 10 * ball[k] + 2);
    EXPECT_TRUE(entry.moved);
    EXPECT_EQ(entry.listed, k == 1);
  }
  for (uint32_t i = 0; i < n; ++i) {
    EXPECT_EQ(records.is_noted(i), i == 1 || i == 3) << i;
    EXPECT_EQ(records.is_moved(i), i == 1 || i == 3) << i;
  }
}

TEST(MovingRecords, AnUpdateKnowsNothingOfTheLastOne) {
  Records made;
  hsp::MovingRecords &records = made.records;
  records.note_moved(2);
  records.note(4);
  EXPECT_TRUE(records.is_noted(4));
  EXPECT_FALSE(records.is_moved(4));
  made.put(2, 200);
  records.begin();
  EXPECT_EQ(records.noted(), 0U);
  for (uint32_t i = 0; i < n; ++i) EXPECT_FALSE(records.is_noted(i) || records.is_moved(i)) << i;
  records.note(2);
  ASSERT_EQ(records.noted(), 1U);
  EXPECT_EQ(records.entry(0).placed.centre.x, 200);
  EXPECT_FALSE(records.entry(0).moved);
}

}  // namespace
