#include <barrier>
#include <thread>
#include <utility>
#include <vector>

#include "expect_cases.hpp"
#include "shared_disjoint_sets_cases.hpp"

namespace {

using Pairs = std::vector<std::pair<uint32_t, uint32_t>>;

// Few sets of many numbers, so that threads come upon each other.
constexpr uint32_t numbers = 400, pairs_to_join = 360, threads = 4, rounds = 400;

Pairs random_pairs(cases::Random &random) {
  Pairs pairs;
  for (uint32_t k = 0; k < pairs_to_join; ++k) {
    const uint32_t first = random.below(numbers);
    pairs.emplace_back(first, random.below(numbers));
  }
  return pairs;
}

}  // namespace

TEST(SharedDisjointSets, Cases) {
  expect_cases(cases::core_shared_disjoint_sets);
}

TEST(SharedDisjointSets, JoinedByThreads) {
  if (!hsp::SharedDisjointSets::available) GTEST_SKIP() << "this processor has no atomic operations";
  cases::Random random(31);
  std::vector<Pairs> sets;
  for (uint32_t round = 0; round < rounds; ++round) sets.push_back(random_pairs(random));
  std::vector<std::vector<uint32_t>> parents(rounds, std::vector<uint32_t>(numbers));
  for (std::vector<uint32_t> &parent : parents) hsp::DisjointSets({parent.data(), numbers}).reset();

  std::barrier start(threads);
  const auto join_own = [&](uint32_t thread) {
    for (uint32_t round = 0; round < rounds; ++round) {
      hsp::SharedDisjointSets shared({parents[round].data(), numbers});
      start.arrive_and_wait();
      for (uint32_t k = thread; k < pairs_to_join; k += threads)
        shared.join(sets[round][k].first, sets[round][k].second);
    }
  };
  std::vector<std::thread> others;
  for (uint32_t thread = 1; thread < threads; ++thread) others.emplace_back(join_own, thread);
  join_own(0);
  for (std::thread &other : others) other.join();

  for (uint32_t round = 0; round < rounds; ++round) {
    std::vector<uint32_t> parent(numbers);
    hsp::DisjointSets alone({parent.data(), numbers});
    alone.reset();
    for (const auto &[a, b] : sets[round]) alone.join(a, b);
    const hsp::DisjointSets shared({parents[round].data(), numbers});
    for (uint32_t k = 0; k < numbers; ++k) ASSERT_EQ(shared.root(k), alone.root(k)) << "round " << round;
  }
}
