// Disjoint sets against labels that are rewritten one by one.
#pragma once

#include "cases.hpp"
#include "core/disjoint_sets.hpp"

namespace cases {

constexpr uint64_t seeds_of_sets[] = {1, 2, 3, 4, 5, 6, 7, 8};

// However the sets were joined.
inline bool smallest_represent(uint64_t seed) {
  constexpr uint32_t n = 60;
  uint32_t parent[n], label[n];
  hsp::DisjointSets sets(hsp::Span<uint32_t>(parent, n));
  sets.reset();
  for (uint32_t k = 0; k < n; ++k) label[k] = k;
  Random random(seed);
  for (uint32_t step = 0; step < 2 * n; ++step) {
    const uint32_t a = random.below(n), b = random.below(n);
    const uint32_t x = label[a], y = label[b];
    if (sets.join(a, b) != (x != y)) return false;
    const uint32_t first = x < y ? x : y;
    for (uint32_t &of : label) {
      if (of == x || of == y) of = first;
    }
    for (uint32_t k = 0; k < n; ++k) {
      if (sets.root(k) != label[k]) return false;
      if (step % 7 == 0 && sets.find(k) != label[k]) return false;
    }
  }
  sets.flatten();
  for (uint32_t k = 0; k < n; ++k) {
    if (parent[k] != label[k]) return false;
  }
  return sets.size() == n;
}
inline uint32_t smaller_numbers_represent() {
  return first_failing(seeds_of_sets, smallest_represent);
}
inline uint32_t joins_that_change_nothing() {
  uint32_t parent[4];
  hsp::DisjointSets sets(hsp::Span<uint32_t>(parent, 4));
  sets.reset();
  const bool conditions[] = {sets.join(3, 2), sets.join(3, 1), !sets.join(1, 2), sets.find(3) == 1, sets.root(0) == 0};
  return first_false(conditions);
}

// Places of numbers, not numbers; the last one is not looked at.
inline uint32_t first_with_another_parent() {
  uint32_t parent[5] = {0, 1, 1, 0, 1};
  const hsp::DisjointSets sets(hsp::Span<uint32_t>(parent, 5));
  const uint32_t numbers[] = {2, 4, 3, 1, 0};
  const bool conditions[] = {sets.first_elsewhere(numbers, 0, 5, 1) == 2, sets.first_elsewhere(numbers, 2, 5, 1) == 2,
                             sets.first_elsewhere(numbers, 3, 5, 1) == 4, sets.first_elsewhere(numbers, 3, 4, 1) == 4,
                             sets.first_elsewhere(numbers, 5, 5, 1) == 5};
  return first_false(conditions);
}

inline constexpr Check core_disjoint_sets[] = {{"smaller_numbers_represent", smaller_numbers_represent},
                                               {"joins_that_change_nothing", joins_that_change_nothing},
                                               {"first_with_another_parent", first_with_another_parent}};

}  // namespace cases
