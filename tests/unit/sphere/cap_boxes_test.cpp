// The caps that boxes list along a circle show the same as all caps; and of large caps that all meet each other they
// list few.
#include "sphere/cap_boxes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "bumps.hpp"
#include "indexed_search.hpp"

namespace {

using oracle::Balls;

constexpr int64_t length = 100000;

// Balls close together on a line, and one beside it, the last.
Balls beside_a_line(oracle::RandomSource &random, uint32_t n, int64_t step, int64_t moved) {
  Balls balls;
  const auto part = [&] { return random.in(-moved, moved); };
  for (int64_t k = 0; k < n; ++k) balls.push_back({k * step + part(), part(), part(), length});
  balls.push_back({random.in(-length, length) / 4, -length - random.in(0, length / 4), random.in(-9, 9), length + 1});
  return balls;
}

// Caps of the last ball whose circles all touch one circle around a direction, which is free or covered inside, nearly.
Balls around_a_circle(oracle::RandomSource &random, uint32_t n, int64_t moved) {
  Balls balls;
  const double angle = 0.2 + static_cast<double>(random.in(0, 1000)) / 1000, cap = 1.2;
  const double radius = static_cast<double>(length) * std::sqrt(2 - 2 * std::cos(cap));
  for (uint32_t k = 0; k < n; ++k) {
    const double turn = 2 * std::numbers::pi * k / n, across = std::sin(angle + cap);
    const auto along = [&](double u) {
      return std::llround(static_cast<double>(length) * u) + random.in(-moved, moved);
    };
    balls.push_back({along(across * std::cos(turn)), along(across * std::sin(turn)), along(std::cos(angle + cap)),
                     std::llround(radius)});
  }
  balls.push_back({0, 0, 0, length + 1});
  return balls;
}

// Copies of one ball that are hardly moved, and one that they meet.
Balls hardly_moved(oracle::RandomSource &random, uint32_t n, int64_t moved) {
  Balls balls;
  for (uint32_t k = 0; k < n; ++k) {
    balls.push_back({random.in(-moved, moved), random.in(-moved, moved), random.in(-moved, moved), length});
  }
  balls.push_back({length, length / 3, 0, length});
  return balls;
}

TEST(CapBoxes, FindWhatAllFind) {
  oracle::RandomSource random(65);
  uint32_t with_boxes = 0, without = 0;
  for (int k = 0; k < 90 && !HasFailure(); ++k) {
    const uint32_t n = static_cast<uint32_t>(random.in(40, 160));
    const Balls balls = k % 6 == 0   ? beside_a_line(random, n, random.in(1, 3000), k % 4 == 0 ? 0 : 5)
                        : k % 6 == 1 ? around_a_circle(random, n, k % 4 == 1 ? 0 : random.in(1, 3000))
                        : k % 6 == 2 ? hardly_moved(random, n, random.in(1, 20000))
                        : k % 6 == 3 ? bumps(random, n, 0.1, 1.2)
                        : k % 6 == 4 ? oracle::any_balls(random, n)
                                     : oracle::degenerate_balls(random, n);
    IndexedSearch search(balls);
    for (uint32_t i = 0; i < search.size(); i += 1 + search.size() / 12) {
      if (!search.gather(i)) continue;
      EXPECT_EQ(search.found(search.cap_boxes()), search.found()) << oracle::to_text(balls) << " ball " << i;
      ++(search.cap_boxes().start(search.caps) ? with_boxes : without);
    }
  }
  EXPECT_GT(with_boxes, 300U);
  EXPECT_GT(without, 100U);
}

// All of them meet. With four times the caps about twice as many are around each: those that are near enough to the way
// along which it is free, from which circles part as parabolas do.
TEST(CapBoxes, ListFew) {
  oracle::RandomSource random(66);
  for (const bool line : {true, false}) {
    uint64_t around[2];
    for (const uint32_t size : {0U, 1U}) {
      const uint32_t n = size == 0 ? 500 : 2000;
      IndexedSearch search(line ? beside_a_line(random, n, 40000 / n, 0) : around_a_circle(random, n, 0));
      uint32_t tried = 0;
      for (uint32_t i = 0; i < search.size(); ++i) {
        if (search.balls().r[i] != length + 1 || !search.gather(i)) continue;
        std::vector<uint32_t> memory(18 * size_t{n});  // as a search in lanes has
        hsp::CapBoxes boxes({memory.data(), static_cast<uint32_t>(memory.size())});
        ASSERT_TRUE(boxes.start(search.caps));
        uint64_t all = 0;
        for (uint32_t j = 0; j < search.caps.count; ++j) all += boxes.around(search.caps, j).size();
        around[size] = all / search.caps.count;
        ++tried;
      }
      EXPECT_EQ(tried, 1U);
    }
    EXPECT_LT(around[0], 350U) << line;
    EXPECT_LT(around[1], 2.5 * static_cast<double>(around[0])) << line;
  }
}

}  // namespace
