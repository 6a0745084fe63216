// Ranges of the terms of a sum.
#pragma once

#include "cases.hpp"
#include "core/summation.hpp"

namespace cases {

struct RangesOfTerms {
  uint32_t terms, workers, count;
};
constexpr RangesOfTerms ranges_of_terms[] = {{0, 4, 0},      {1, 4, 1},      {64, 1, 1},         {65, 1, 2},
                                             {256, 1, 4},    {257, 1, 3},    {4096, 4, 16},      {4097, 4, 9},
                                             {5000, 16, 40}, {4096, 99, 32}, {268435455, 99, 32}};

// One after the other without a gap, and no more than there is room for.
inline uint32_t ranges_follow_each_other() {
  return first_failing(ranges_of_terms, [](const RangesOfTerms &c) {
    const hsp::TermRanges ranges(c.terms, c.workers);
    uint32_t last = 0;
    bool follow = ranges.count() == c.count && c.count <= hsp::TermRanges::most;
    for (uint32_t range = 0; range < ranges.count(); ++range) {
      follow = follow && ranges[range].first == last && !ranges[range].empty();
      last = ranges[range].last;
    }
    return follow && last == c.terms;
  });
}

inline uint32_t sums_of_ranges_are_one_sum() {
  return first_failing(ranges_of_terms, [](const RangesOfTerms &c) {
    if (c.terms > 10000) return true;
    const hsp::TermRanges ranges(c.terms, c.workers);
    hsp::TreeSum whole, of_sums;
    double rest = 0.0;
    for (uint32_t range = 0; range < ranges.count(); ++range) {
      hsp::TreeSum part;
      for (const uint32_t k : ranges[range]) {
        const double term = 1.0 / (k + 1) - 0.001;
        whole.add(term);
        part.add(term);
      }
      range < ranges.complete() ? of_sums.add(part.total()) : static_cast<void>(rest = part.total());
    }
    return of_sums.total(rest) == whole.total();
  });
}

inline constexpr Check core_term_ranges[] = {{"ranges_follow_each_other", ranges_follow_each_other},
                                             {"sums_of_ranges_are_one_sum", sums_of_ranges_are_one_sum}};

}  // namespace cases
