// Sums as a binary tree over the terms.
#pragma once

#include "cases.hpp"
#include "core/summation.hpp"

namespace cases {

// ((1 + e) + (e + e)) + e with e half an ulp of 1: only the pair e + e survives.
inline uint32_t adds_in_a_binary_tree() {
  const double e = 0x1p-53;
  const double terms[] = {1.0, e, e, e, e};
  hsp::TreeSum sum;
  for (const double term : terms) sum.add(term);
  const bool conditions[] = {sum.total() == ((1.0 + e) + (e + e)) + e, sum.total() > 1.0};
  return first_false(conditions);
}

struct ManyTerms {
  double term;
  uint32_t count;
  double sum, tolerance;
};
// A tenth is off by 5.6e-18; a running sum of a million of them is off by 1e-6.
constexpr ManyTerms many_terms[] = {
    {0.1, 0, 0.0, 0.0},         {0.1, 1, 0.1, 0.0},          {0.25, 7, 1.75, 0.0},          {1.0, 65535, 65535.0, 0.0},
    {1.0, 65536, 65536.0, 0.0}, {3.0, 65537, 196611.0, 0.0}, {0.1, 1000003, 100000.3, 1e-9}};

inline uint32_t errors_stay_small() {
  return first_failing(many_terms, [](const ManyTerms &c) {
    hsp::TreeSum sum;
    for (uint32_t k = 0; k < c.count; ++k) sum.add(c.term);
    return near(sum.total(), c.sum, c.tolerance);
  });
}

inline constexpr Check core_summation[] = {{"adds_in_a_binary_tree", adds_in_a_binary_tree},
                                           {"errors_stay_small", errors_stay_small}};

}  // namespace cases
