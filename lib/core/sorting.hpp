// Sorting in place without recursion and without heap memory (std::sort recurses, std::stable_sort allocates).
#pragma once

#include "core/span.hpp"

namespace hsp {

// Insertion sort below 24 items, heap sort above: O(n log n) at worst, constant stack.
template <class T, class Less>
void sort_in_place(Span<T> items, Less less) {
  const uint32_t n = items.size();
  if (n < 24) {
    for (uint32_t k = 1; k < n; ++k) {
      const T item = items[k];
      uint32_t place = k;
      for (; place > 0 && less(item, items[place - 1]); --place) items[place] = items[place - 1];
      items[place] = item;
    }
    return;
  }
  const auto sift_down = [&](uint32_t hole, uint32_t size) {
    const T item = items[hole];
    for (uint32_t child = 2 * hole + 1; child < size; child = 2 * hole + 1) {
      if (child + 1 < size && less(items[child], items[child + 1])) ++child;
      if (!less(item, items[child])) break;
      items[hole] = items[child];
      hole = child;
    }
    items[hole] = item;
  };
  for (uint32_t k = n / 2; k-- > 0;) sift_down(k, n);
  for (uint32_t size = n - 1; size > 0; --size) {
    const T largest = items[0];
    items[0] = items[size];
    items[size] = largest;
    sift_down(0, size);
  }
}

}  // namespace hsp
