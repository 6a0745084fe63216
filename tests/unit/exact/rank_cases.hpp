// The order of ranks: by x, then y, z, radius and index, each alone.
#pragma once

#include "cases.hpp"
#include "exact/rank.hpp"

namespace cases {

struct RankPair {
  hsp::exact::RankKey<int64_t> first, second;  // in this order
};
constexpr RankPair rank_pairs[] = {{{1, 9, 9, 9, 9}, {2, 0, 0, 0, 0}},  {{-5, 9, 9, 9, 9}, {3, 0, 0, 0, 0}},
                                   {{1, 1, 9, 9, 9}, {1, 2, 0, 0, 0}},  {{1, 1, 1, 9, 9}, {1, 1, 2, 0, 0}},
                                   {{1, 1, 1, 1, 9}, {1, 1, 1, 2, 0}},  {{1, 1, 1, 1, 1}, {1, 1, 1, 1, 2}},
                                   {{0, -1, 9, 9, 9}, {0, 0, -9, 0, 0}}};

inline uint32_t ranks_are_lexicographic() {
  return first_failing(rank_pairs, [](const RankPair &c) {
    using Rounded = hsp::exact::RankKey<double>;
    const auto rounded = [](const hsp::exact::RankKey<int64_t> &k) {
      return Rounded{static_cast<double>(k.x), static_cast<double>(k.y), static_cast<double>(k.z),
                     static_cast<double>(k.R), k.index};
    };
    return ranks_before(c.first, c.second) && !ranks_before(c.second, c.first) && !ranks_before(c.first, c.first) &&
           ranks_before(rounded(c.first), rounded(c.second)) && !ranks_before(rounded(c.second), rounded(c.first));
  });
}

inline constexpr Check exact_rank[] = {{"ranks_are_lexicographic", ranks_are_lexicographic}};

}  // namespace cases
