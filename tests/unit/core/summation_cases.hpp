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

// Zeros before, between and behind other terms: as one by one, with their sign.
struct ManyZeros {
  uint32_t before, zeros, behind;
  double zero;
};
constexpr ManyZeros many_zeros[] = {{0, 16, 0, -0.0}, {0, 100, 0, -0.0}, {1, 15, 3, 0.0},   {1, 16, 3, 0.0},
                                    {5, 64, 40, 0.0}, {16, 33, 1, -0.0}, {40, 1000, 7, 0.0}};

inline uint32_t zeros_at_once_are_zeros_one_by_one() {
  return first_failing(many_zeros, [](const ManyZeros &c) {
    hsp::TreeSum at_once, one_by_one;
    const auto add = [&](uint32_t count) {
      for (uint32_t k = 0; k < count; ++k) {
        at_once.add(0.1 + k);
        one_by_one.add(0.1 + k);
      }
    };
    add(c.before);
    at_once.add_zeros(c.zero, c.zeros);
    for (uint32_t k = 0; k < c.zeros; ++k) one_by_one.add(c.zero);
    add(c.behind);
    const double a = at_once.total(-0.0), b = one_by_one.total(-0.0);
    return a == b && std::signbit(a) == std::signbit(b);
  });
}

// A row of terms behind others that wait: as one by one.
inline uint32_t rows_are_terms_one_by_one() {
  constexpr uint32_t most = 80;
  double term[most];
  for (uint32_t k = 0; k < most; ++k) term[k] = 0.1 + k / 7.0;
  for (uint32_t before = 0; before < 20; ++before) {
    for (uint32_t last = before; last <= most; ++last) {
      hsp::TreeSum row, one_by_one;
      for (uint32_t k = 0; k < last; ++k) one_by_one.add(term[k]);
      for (uint32_t k = 0; k < before; ++k) row.add(term[k]);
      row.add(term + before, last - before);
      if (row.total() != one_by_one.total()) return before;
    }
  }
  return all_hold;
}

inline constexpr Check core_summation[] = {{"adds_in_a_binary_tree", adds_in_a_binary_tree},
                                           {"errors_stay_small", errors_stay_small},
                                           {"zeros_at_once_are_zeros_one_by_one", zeros_at_once_are_zeros_one_by_one},
                                           {"rows_are_terms_one_by_one", rows_are_terms_one_by_one}};

}  // namespace cases
