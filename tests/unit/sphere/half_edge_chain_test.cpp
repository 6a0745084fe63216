// The followers of all half-edges of one sphere at once against those that find_next() finds one by one: few half-edges
// and many, circles with several arcs, and arcs that are a whole turn but for an infinitely small gap.
#include "sphere/half_edge_chain.hpp"

#include <gtest/gtest.h>

#include <set>
#include <utility>
#include <vector>

#include "random_balls.hpp"

namespace {

// Directions on a circle around each axis are different, as the caps of one sphere that have free points.
hsp::exact::Vector direction(uint32_t circle) {
  const int64_t k = circle;
  return {1000 + k * k, 37 * k - 400, (k * 7919) % 1009 - 500};
}

// Half-edges as the vertices of a sphere give them: no two arrive along one circle and leave along another alike, and
// what arrives along a circle leaves along it elsewhere.
std::vector<hsp::HalfEdge> random_half_edges(oracle::RandomSource &random, uint32_t count, uint32_t circles) {
  std::vector<hsp::HalfEdge> half_edges;
  std::set<std::pair<uint32_t, uint32_t>> known;
  const auto other_than = [&](uint32_t circle) {
    return (circle + 1 + static_cast<uint32_t>(random.in(0, circles - 2))) % circles;
  };
  uint32_t start = 0, at = 0;
  for (uint32_t tries = 0; tries < 20 * count && half_edges.size() < count; ++tries) {
    // Back to where the loop began, now and then.
    const uint32_t to = at != start && random.in(0, 3) == 0 ? start : other_than(at);
    if (!known.insert({at, to}).second) continue;
    half_edges.push_back({tries, at, to, hsp::no_id, hsp::no_id});
    at = to;
    if (at == start) start = at = static_cast<uint32_t>(random.in(0, circles - 1));
  }
  while (at != start) {
    const uint32_t to = known.count({at, start}) == 0 ? start : other_than(at);
    if (known.insert({at, to}).second) half_edges.push_back({0, at, to, hsp::no_id, hsp::no_id});
    at = to;
  }
  for (size_t k = half_edges.size(); k > 1; --k) {
    std::swap(half_edges[k - 1], half_edges[static_cast<size_t>(random.in(0, static_cast<int64_t>(k) - 1))]);
  }
  return half_edges;
}

TEST(HalfEdgeChain, FindsTheFollowersOfFindNext) {
  oracle::RandomSource random(51);
  constexpr uint32_t most_circles = 60;
  std::vector<uint32_t> arriving(most_circles, 77), leaving(most_circles, 77);
  const hsp::HalfEdgeChain chain({arriving.data(), most_circles}, {leaving.data(), most_circles});
  int several = 0;
  for (int round = 0; round < 20000; ++round) {
    const uint32_t circles = static_cast<uint32_t>(random.in(2, round % 2 == 0 ? 9 : most_circles));
    const uint32_t about = static_cast<uint32_t>(random.in(0, round % 100 == 0 ? 70 : 34));
    std::vector<hsp::HalfEdge> half_edges = random_half_edges(random, about, circles);
    const uint32_t count = static_cast<uint32_t>(half_edges.size());
    const std::vector<hsp::HalfEdge> before = half_edges;
    chain.link({half_edges.data(), count}, 1000, direction);
    for (uint32_t k = 0; k < count; ++k) {
      const uint32_t expected = hsp::find_next({before.data(), count}, before[k], direction);
      ASSERT_EQ(half_edges[k].next, 1000 + expected) << k << " of " << count << ", " << circles << " circles";
      int candidates = 0;
      for (const hsp::HalfEdge &other : before) candidates += other.previous_circle == before[k].circle;
      several += candidates > 2;
    }
  }
  EXPECT_GT(several, 10000);
  for (uint32_t circle = 0; circle < most_circles; ++circle) {
    ASSERT_EQ(arriving[circle] | leaving[circle], 0U) << "the words are not 0 again";
  }
}

}  // namespace
