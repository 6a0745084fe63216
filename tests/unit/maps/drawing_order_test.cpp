// Orders against all pairs, and cycles.
#include "maps/stick_sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "carved_memory.hpp"
#include "random_balls.hpp"

namespace {

using Pairs = std::vector<hsp::StickPair>;

struct Sorter {
  explicit Sorter(const Pairs &given, std::vector<double> depths) : pairs(given), depth(std::move(depths)) {
    const auto bodies = static_cast<uint32_t>(depth.size());
    memory.carve(sorter, hsp::StickLimits{bodies, 0, static_cast<uint32_t>(pairs.size())});
    order.assign(bodies, 0);
    placed = sorter.sort(list(), {depth.data(), bodies}, {order.data(), bodies});
  }
  hsp::Span<const hsp::StickPair> list() const { return {pairs.data(), static_cast<uint32_t>(pairs.size())}; }
  hsp::DrawingOrder::Cycle cycle() { return sorter.find_cycle(list(), static_cast<uint32_t>(depth.size())); }

  Pairs pairs;
  std::vector<double> depth;
  CarvedMemory memory;
  hsp::DrawingOrder sorter;
  std::vector<uint32_t> order;
  uint32_t placed = 0;
};

TEST(DrawingOrder, GoesByDepthWherePairsAllowIt) {
  EXPECT_EQ(Sorter({}, {3, 1, 2, 1}).order, (std::vector<uint32_t>{1, 3, 2, 0}));
  EXPECT_EQ(Sorter({{0, 1}}, {3, 1, 2, 1}).order, (std::vector<uint32_t>{3, 2, 0, 1}));
  EXPECT_EQ(Sorter({{0, 1}, {0, 1}, {2, 3}, {1, 2}}, {3, 1, 2, 1}).order, (std::vector<uint32_t>{0, 1, 2, 3}));
  EXPECT_EQ(Sorter({}, {}).placed, 0U);
}

TEST(DrawingOrder, PutsWhatCoversLater) {
  oracle::RandomSource random(51);
  for (int time = 0; time < 200; ++time) {
    const uint32_t n = 1 + static_cast<uint32_t>(random.below(60));
    const std::vector<uint32_t> hidden = random.permutation(n);
    std::vector<double> depth;
    for (uint32_t k = 0; k < n; ++k) depth.push_back(static_cast<double>(random.below(10)));
    Pairs pairs;
    for (uint32_t k = 0; n > 1 && k < 2 * n; ++k) {
      const auto a = static_cast<uint32_t>(random.below(n));
      const auto b = static_cast<uint32_t>(random.below(n));
      if (a != b) pairs.push_back({hidden[std::min(a, b)], hidden[std::max(a, b)]});
    }
    const Sorter sorter(pairs, depth);
    ASSERT_EQ(sorter.placed, n);
    std::vector<uint32_t> place(n, n);
    for (uint32_t k = 0; k < n; ++k) place[sorter.order[k]] = k;
    for (const uint32_t at : place) ASSERT_LT(at, n);
    for (const hsp::StickPair &pair : pairs) ASSERT_LT(place[pair.below], place[pair.above]);
  }
}

TEST(DrawingOrder, FindsCycles) {
  Sorter sorter({{0, 1}, {1, 2}, {2, 3}, {3, 1}, {3, 4}, {4, 5}}, {0, 0, 0, 0, 0, 0, 0});
  EXPECT_EQ(sorter.placed, 2U);
  EXPECT_EQ(sorter.cycle().last, 3U);
  EXPECT_EQ(sorter.cycle().length, 3U);
  Sorter none({{0, 1}}, {0, 0});
  EXPECT_EQ(none.cycle().length, 0U);
}

}  // namespace
