// Ranges of ids: what they visit is what they contain.
#pragma once

#include "cases.hpp"
#include "core/id_range.hpp"

namespace cases {

constexpr hsp::IdRange id_ranges[] = {{0, 0}, {0, 1}, {5, 5}, {5, 9}, {7, 40}, {UINT32_MAX - 3, UINT32_MAX}};

inline uint32_t ranges_visit_what_they_contain() {
  return first_failing(id_ranges, [](const hsp::IdRange &range) {
    uint32_t expected = range.first;
    for (const uint32_t id : range) {
      if (id != expected++ || !range.contains(id)) return false;
    }
    return expected == range.last && range.size() == range.last - range.first && range.empty() == (range.size() == 0) &&
           !range.contains(range.last) && !range.contains(range.first - 1);
  });
}

inline constexpr Check core_id_range[] = {{"ranges_visit_what_they_contain", ranges_visit_what_they_contain}};

}  // namespace cases
