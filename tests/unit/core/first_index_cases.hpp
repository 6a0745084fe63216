// The first index where a predicate holds: against asking all of them, and never asking one that is not there.
#pragma once

#include "cases.hpp"
#include "core/first_index.hpp"

namespace cases {

// From where on it holds, and where to look.
struct IndexSearch {
  uint32_t begins, first, last;
};

constexpr uint32_t expected_index(const IndexSearch &search) {
  uint32_t k = search.first;
  while (k < search.last && k < search.begins) ++k;
  return k;
}

constexpr bool finds_index(const IndexSearch &search) {
  bool all_there = true;
  const uint32_t found = hsp::first_index(search.first, search.last, [&](uint32_t k) {
    all_there = all_there && k >= search.first && k < search.last;
    return k >= search.begins;
  });
  return all_there && found == expected_index(search);
}

constexpr IndexSearch index_searches[] = {{3000000000, 2999999995, 3000000004},
                                          {0, 4294967290, 4294967295},
                                          {4294967295, 4294967290, 4294967295},
                                          {0, 0, 4294967294},
                                          {9, 5, 5}};

inline uint32_t finds_first_index() {
  return first_failing(index_searches, finds_index);
}

inline uint32_t finds_first_index_in_every_range() {
  constexpr uint32_t lengths[] = {0, 1, 2, 3, 4, 7, 8, 20};
  return first_failing(lengths, [](uint32_t last) {
    for (uint32_t first = 0; first <= last; ++first) {
      for (uint32_t begins = 0; begins <= last + 1; ++begins) {
        if (!finds_index({begins, first, last})) return false;
      }
    }
    return true;
  });
}

inline constexpr Check core_first_index[] = {{"finds_first_index", finds_first_index},
                                             {"finds_first_index_in_every_range", finds_first_index_in_every_range}};

}  // namespace cases
