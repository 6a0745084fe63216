// Sorts items into rows of one array, by a counting sort: row k is at positions first[k] to first[k + 1] - 1, and its
// items are in the order in which they are given.
//
// As an example three items of rows 1, 0 and 1:
//   counted                     first  1 2
//   end_rows(first, 2) = 3      first  1 3 3
//   items 2, 1 and 0 are put at 2, 0 and 1, and  first  0 1 3:  row 0 has item 1, row 1 has items 0 and 2
#pragma once

#include "core/span.hpp"

namespace hsp {

// On entry first[0 .. rows - 1] holds the number of items of each row; it becomes the end of each row. Returns the sum,
// which becomes first[rows]. Then the caller puts each item, the last one first, at position --first[its row]. This
// leaves the beginning of each row in `first`.
constexpr uint32_t end_rows(Span<uint32_t> first, uint32_t rows) {
  uint32_t end = 0;
  for (uint32_t k = 0; k < rows; ++k) first[k] = end += first[k];
  return first[rows] = end;
}

// Does all of this for items 0 to `items` - 1: row_of(item) is the row of an item, or `rows` if it is in none. Calls
// put(position, item), always after row_of(item), and returns how many items were put. first [rows + 1].
template <class RowOf, class Put>
uint32_t sort_to_rows(Span<uint32_t> first, uint32_t rows, uint32_t items, RowOf row_of, Put put) {
  for (uint32_t k = 0; k <= rows; ++k) first[k] = 0;
  for (uint32_t item = 0; item < items; ++item) ++first[row_of(item)];
  const uint32_t end = end_rows(first, rows);
  for (uint32_t item = items; item-- > 0;) {
    const uint32_t row = row_of(item);
    if (row < rows) put(--first[row], item);
  }
  return end;
}

}  // namespace hsp
