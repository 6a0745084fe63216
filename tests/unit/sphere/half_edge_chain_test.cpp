// The followers of all half-edges of one sphere at once against those that find_next() finds one by one: few half-edges
// and many, in any order, and circles with several arcs.
#include "sphere/half_edge_chain.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "balls_around.hpp"
#include "built_boundary.hpp"
#include "find_next.hpp"

namespace {

struct Item {
  uint32_t previous_circle, circle, next;
};
uint32_t previous(const Item &item) {
  return item.previous_circle;
}

struct Seen {
  int half_edges = 0, several = 0, many = 0;
};

void check(const BuiltBoundary &built, const hsp::HalfEdgeChain &chain, oracle::RandomSource &random, Seen &seen) {
  const hsp::Boundary &boundary = built.boundary();
  for (uint32_t i = 0; i < boundary.ball_count(); ++i) {
    std::vector<Item> items;
    for (const uint32_t e : boundary.half_edges(i)) {
      const hsp::HalfEdge &half_edge = boundary.half_edge(e);
      items.push_back({boundary.previous_circle(i, half_edge), half_edge.circle, hsp::no_id});
    }
    const uint32_t count = static_cast<uint32_t>(items.size());
    for (uint32_t k = count; k > 1; --k) std::swap(items[k - 1], items[random.below(k)]);
    const auto direction = [&](uint32_t j) { return built.balls().exact_difference(i, j); };
    const hsp::Span<Item> all(items.data(), count);
    const std::vector<Item> given = items;
    chain.link(all, 1000, &Item::previous_circle, direction);
    for (uint32_t k = 0; k < count; ++k) {
      ASSERT_EQ(items[k].previous_circle, given[k].previous_circle);
      ASSERT_EQ(items[k].next, 1000 + support::find_next(all, items[k], previous, direction)) << k << " of " << count;
      int candidates = 0;
      for (const Item &other : items) candidates += other.previous_circle == items[k].circle;
      seen.several += candidates > 1;
    }
    seen.half_edges += static_cast<int>(count);
    seen.many += count > hsp::HalfEdgeChain::most;
  }
}

TEST(HalfEdgeChain, FindsTheFollowersOfFindNext) {
  oracle::RandomSource random(51);
  constexpr uint32_t most_balls = 200;
  std::vector<uint32_t> arriving(most_balls, 77), leaving(most_balls, 77);
  const hsp::HalfEdgeChain chain({arriving.data(), most_balls}, {leaving.data(), most_balls});
  Seen seen;
  for (int round = 0; round < 300; ++round) {
    const size_t more = static_cast<size_t>(random.in(0, round % 10 == 0 ? 120 : 30));
    const BuiltBoundary built(balls_around(random, more, 60, round % 2 == 0 ? 250 : 600));
    ASSERT_EQ(built.status(), hsp::Status::ok);
    check(built, chain, random, seen);
  }
  EXPECT_GT(seen.half_edges, 10000);
  EXPECT_GT(seen.several, 1000);
  EXPECT_GT(seen.many, 10);
  for (uint32_t circle = 0; circle < most_balls; ++circle) {
    ASSERT_EQ(arriving[circle] | leaving[circle], 0U) << "the words are not 0 again";
  }
}

}  // namespace
