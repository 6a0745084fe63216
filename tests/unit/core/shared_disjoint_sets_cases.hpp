// Disjoint sets that may be shared against those that may not. Where the processor cannot share them there are none.
#pragma once

#include "cases.hpp"
#include "core/disjoint_sets.hpp"
#include "core/shared_disjoint_sets.hpp"

namespace cases {

// However the sets were joined.
inline bool shared_sets_agree(uint64_t seed) {
  constexpr uint32_t n = 60;
  uint32_t parent[2][n];
  hsp::DisjointSets sets(hsp::Span<uint32_t>(parent[0], n));
  hsp::DisjointSets result(hsp::Span<uint32_t>(parent[1], n));
  hsp::SharedDisjointSets shared(hsp::Span<uint32_t>(parent[1], n));
  sets.reset();
  result.reset();
  Random random(seed);
  for (uint32_t step = 0; step < 2 * n; ++step) {
    const uint32_t a = random.below(n), b = random.below(n);
    sets.join(a, b);
    shared.join(a, b);
    for (uint32_t k = 0; k < n; ++k) {
      if (parent[1][k] > k || result.root(k) != sets.root(k)) return false;
    }
  }
  return true;
}
inline uint32_t shared_sets_are_sets() {
  if (!hsp::SharedDisjointSets::available) return all_hold;
  constexpr uint64_t seeds[] = {1, 2, 3, 4, 5, 6, 7, 8};
  return first_failing(seeds, shared_sets_agree);
}

inline constexpr Check core_shared_disjoint_sets[] = {{"shared_sets_are_sets", shared_sets_are_sets}};

}  // namespace cases
