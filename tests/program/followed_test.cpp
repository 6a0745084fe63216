// Which cavity of a frame is which one of those before, from lists of balls alone.
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

extern "C" {
#include "commands/followed.h"
}

namespace {

using Balls = std::vector<uint32_t>;

class Course {
 public:
  Course() {
    std::memset(&followed_, 0, sizeof followed_);
    std::memset(&molecule_, 0, sizeof molecule_);
    molecule_.atoms = 100;
  }
  Course(const Course &) = delete;
  Course &operator=(const Course &) = delete;
  ~Course() { followed_free(&followed_); }

  // The numbers of the next frame's cavities.
  Balls next(const std::vector<Balls> &lists) {
    cavities_.assign(lists.size(), cavity{});
    for (size_t k = 0; k < lists.size(); ++k) {
      cavities_[k].balls = lists[k].data();
      cavities_[k].ball_count = static_cast<uint32_t>(lists[k].size());
    }
    ++molecule_.frame.number;
    failure why;
    std::memset(&why, 0, sizeof why);
    EXPECT_TRUE(followed_take(&followed_, &molecule_, cavities_.data(), static_cast<uint32_t>(cavities_.size()), &why));
    Balls numbers;
    for (const cavity &each : cavities_) numbers.push_back(each.number);
    return numbers;
  }
  [[nodiscard]] Balls from() const {
    Balls numbers;
    for (const cavity &each : cavities_) numbers.push_back(each.from);
    return numbers;
  }
  [[nodiscard]] Balls merged(size_t k) const {
    return {cavities_[k].merged, cavities_[k].merged + cavities_[k].merged_count};
  }

 private:
  followed followed_;
  molecule molecule_;
  std::vector<cavity> cavities_;
};

TEST(Followed, HalfOfThatWhichHasFewer) {
  Course run;
  EXPECT_EQ(run.next({{0, 1, 2, 3, 4, 5}, {10, 11, 12, 13, 14, 15, 16}}), (Balls{1, 2}));
  EXPECT_EQ(run.next({{3, 4, 5, 50, 51, 52, 53, 54}, {14, 15, 16, 60, 61, 62, 63, 64}}), (Balls{1, 3}));
  EXPECT_EQ(run.from(), (Balls{0, 0}));
  // The second one opens again where it was, beside the one that has come.
  EXPECT_EQ(run.next({{10, 11, 12, 13}, {60, 61, 62, 63}, {}}), (Balls{2, 3, 4}));
  EXPECT_EQ(run.next({}), (Balls{}));
  EXPECT_EQ(run.next({{60, 61}, {3, 4}}), (Balls{3, 1}));
}

// The pair that has most of what either has comes first, whatever the order of lists.
TEST(Followed, TheMostAlike) {
  for (const bool turned : {false, true}) {
    Course run;
    run.next({{0, 1, 2, 3, 4, 5, 6, 7}, {10, 11, 12, 13}});
    const Balls most = {0, 1, 2, 3, 4}, rest = {5, 6, 7, 20}, both = {10, 11, 12, 13, 21};
    const Balls split = turned ? run.next({rest, most, both}) : run.next({most, rest, both});
    EXPECT_EQ(split, turned ? (Balls{3, 1, 2}) : (Balls{1, 3, 2}));
    EXPECT_EQ(run.from(), turned ? (Balls{1, 0, 0}) : (Balls{0, 1, 0}));
    EXPECT_TRUE(run.merged(0).empty());
    // All three become one, of which the first has most.
    EXPECT_EQ(run.next({{0, 1, 2, 3, 4, 5, 6, 7, 20, 10, 11, 12, 13, 21}}), (Balls{1}));
    EXPECT_EQ(run.merged(0).size(), 2U);
    // And the same parts again have the numbers that they had: no others look as much like them.
    EXPECT_EQ(run.next({both, rest, most}), (Balls{2, 3, 1}));
    EXPECT_EQ(run.from(), (Balls{1, 1, 0}));
  }
}

TEST(Followed, TiesGoByNumbers) {
  Course run;
  run.next({{0, 1}, {2, 3}});
  EXPECT_EQ(run.next({{0, 2}, {1, 3}}), (Balls{1, 2}));
  EXPECT_EQ(run.next({{0, 1, 2, 3}}), (Balls{1}));
  EXPECT_EQ(run.merged(0), (Balls{2}));
}

}  // namespace
