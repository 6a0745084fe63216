// Rows: each item in its own row, in the order in which the items are given, and those without a row nowhere.
#pragma once

#include "cases.hpp"
#include "core/rows.hpp"

namespace cases {

struct ToRows {
  uint32_t items, rows;
  uint32_t kinds;  // rows drawn from so many; as many as `rows` and one more leave items without a row
};
constexpr ToRows to_rows[] = {{0, 0, 1}, {0, 3, 3},  {1, 1, 1},  {5, 0, 1},    {7, 1, 2},   {40, 40, 3},
                              {9, 3, 1}, {90, 7, 7}, {90, 7, 8}, {100, 20, 5}, {100, 2, 3}, {100, 60, 61}};

inline uint32_t items_are_in_their_rows() {
  return first_failing(to_rows, [](const ToRows &c) {
    uint32_t row[100], first[62], put[100];
    Random random(c.items + 131 * c.rows);
    for (uint32_t k = 0; k < c.items; ++k) row[k] = random.below(c.kinds);
    for (uint32_t &each : first) each = 77;
    for (uint32_t &each : put) each = UINT32_MAX;
    uint32_t last = UINT32_MAX;
    bool row_first = true;
    const uint32_t total = hsp::sort_to_rows(
        hsp::Span<uint32_t>(first, 62), c.rows, c.items, [&](uint32_t item) { return row[last = item]; },
        [&](uint32_t at, uint32_t item) {
          row_first = row_first && last == item;
          put[at] = item;
        });
    uint32_t at = 0;
    for (uint32_t r = 0; r < c.rows; ++r) {
      if (first[r] != at) return false;
      for (uint32_t k = 0; k < c.items; ++k) {
        if (row[k] == r && put[at++] != k) return false;
      }
    }
    return row_first && total == at && first[c.rows] == at && first[c.rows + 1] == 77;
  });
}

inline constexpr Check core_rows[] = {{"items_are_in_their_rows", items_are_in_their_rows}};

}  // namespace cases
