// Sorting in place without recursion and without heap memory (std::sort recurses, std::stable_sort allocates).
//
// As an example a heap. Below item k are items 2 k + 1 and 2 k + 2, and no item is less than those below it:
//          9
//        7   5          as an array   9 7 5 3 6
//       3 6
// With 2 in place of the 9, sift_down() moves 7 up, then 6, and puts 2 there: 7 6 5 3 2.
#pragma once

#include "core/span.hpp"

namespace hsp {

// Moves the item at `hole` down a heap, or up, until no item is less than one below it. Calls placed(item, slot) for
// each item that moves, with its new slot.
template <class T, class Less, class Placed>
void sift_down(Span<T> heap, uint32_t hole, Less less, Placed placed) {
  const T item = heap[hole];
  for (uint32_t child = 2 * hole + 1; child < heap.size(); child = 2 * hole + 1) {
    if (child + 1 < heap.size() && less(heap[child], heap[child + 1])) ++child;
    if (!less(item, heap[child])) break;
    heap[hole] = heap[child];
    placed(heap[hole], hole);
    hole = child;
  }
  heap[hole] = item;
  placed(item, hole);
}
template <class T, class Less, class Placed>
void sift_up(Span<T> heap, uint32_t hole, Less less, Placed placed) {
  const T item = heap[hole];
  for (; hole > 0 && less(heap[(hole - 1) / 2], item); hole = (hole - 1) / 2) {
    heap[hole] = heap[(hole - 1) / 2];
    placed(heap[hole], hole);
  }
  heap[hole] = item;
  placed(item, hole);
}
template <class T, class Less>
void sift_down(Span<T> heap, uint32_t hole, Less less) {
  sift_down(heap, hole, less, [](const T &, uint32_t) {});
}
template <class T, class Less>
void sift_up(Span<T> heap, uint32_t hole, Less less) {
  sift_up(heap, hole, less, [](const T &, uint32_t) {});
}

// Insertion sort below 24 items, heap sort above: O(n log n) at worst, constant stack.
template <class T, class Less>
void sort_in_place(Span<T> items, Less less) {
  const uint32_t n = items.size();
  if (n < 24) {
    for (uint32_t k = 1; k < n; ++k) {
      const T item = items[k];
      uint32_t slot = k;
      for (; slot > 0 && less(item, items[slot - 1]); --slot) items[slot] = items[slot - 1];
      items[slot] = item;
    }
    return;
  }
  // First makes the heap; then puts its largest item behind the rest, again and again. Both are one loop, so that the
  // code of sift_down() is there once.
  for (uint32_t size = n, hole = n / 2; size > 1;) {
    if (hole > 0) {
      --hole;
    } else {
      const T largest = items[0];
      items[0] = items[--size];
      items[size] = largest;
    }
    sift_down(items.part(0, size), hole, less);
  }
}

// The same by slots. slot_of(item) < slots estimates where in order an item is. O(n) if each slot holds few items and
// slot_of() never contradicts the order; else as sort_in_place(). scratch [2 slots + 1]. goes_on() is asked for each
// item; once it says no the sort ends, and items may be lost.
template <class T, class SlotOf, class Less, class GoesOn>
void sort_by_slot(Span<T> items, Span<uint32_t> scratch, uint32_t slots, SlotOf slot_of, Less less, GoesOn goes_on) {
  const Span<uint32_t> first = scratch.part(0, slots + 1);
  const Span<uint32_t> next = scratch.part(slots + 1, 2 * slots + 1);
  for (uint32_t &each : first) each = 0;
  for (const T &item : items) {
    if (!goes_on()) return;
    ++first[slot_of(item) + 1];
  }
  for (uint32_t p = 0; p < slots; ++p) {
    first[p + 1] += first[p];
    next[p] = first[p];
  }
  for (uint32_t p = 0; p < slots; ++p) {
    while (next[p] < first[p + 1]) {
      T item = items[next[p]];
      for (uint32_t q = slot_of(item); q != p; q = slot_of(item)) {
        const T displaced = items[next[q]];
        items[next[q]++] = item;
        item = displaced;
      }
      items[next[p]++] = item;
      if (!goes_on()) return;
    }
  }
  bool in_order = true;
  for (uint32_t p = 0; p < slots; ++p) {
    if (first[p] == first[p + 1]) continue;
    sort_in_place(items.part(first[p], first[p + 1]), less);
    if (first[p] > 0 && less(items[first[p]], items[first[p] - 1])) in_order = false;
  }
  if (!in_order) sort_in_place(items, less);
}

// The same for items that are spread evenly over their range, with slot_of(item, slots) < slots. scratch [items].
template <class T, class SlotOf, class Less>
void sort_by_slot(Span<T> items, Span<uint32_t> scratch, SlotOf slot_of, Less less) {
  if (items.size() < 24) return sort_in_place(items, less);
  const uint32_t slots = (items.size() - 1) / 2;
  sort_by_slot(
      items, scratch, slots, [&](const T &item) { return slot_of(item, slots); }, less, [] { return true; });
}

// The same for items that number_of(item) spreads evenly, by which less() sorts in ascending order. With less scratch
// memory as sort_in_place().
template <class T, class NumberOf, class Less>
void sort_by_number(Span<T> items, Span<uint32_t> scratch, NumberOf number_of, Less less) {
  if (items.size() < 24 || scratch.size() < items.size()) return sort_in_place(items, less);
  double low = number_of(items[0]), high = low;
  for (const T &item : items) {
    const double number = number_of(item);
    low = number < low ? number : low;
    high = number > high ? number : high;
  }
  const double scale = high > low ? 1.0 / (high - low) : 0.0;
  sort_by_slot(
      items, scratch,
      [&](const T &item, uint32_t slots) {
        return static_cast<uint32_t>((number_of(item) - low) * scale * (slots - 1));
      },
      less);
}

// Sorts three items, and returns whether the number of exchanges is odd.
template <class T, class Less>
bool sort_three(T &a, T &b, T &c, Less less) {
  bool odd = false;
  const auto order = [&](T &first, T &second) {
    if (!less(second, first)) return;
    const T later = first;
    first = second;
    second = later;
    odd = !odd;
  };
  order(a, b);
  order(b, c);
  order(a, b);
  return odd;
}
inline bool sort_three(uint32_t &a, uint32_t &b, uint32_t &c) {
  return sort_three(a, b, c, [](uint32_t p, uint32_t q) { return p < q; });
}

// Numbers in ascending order, twice as fast.
void sort_ascending(Span<uint32_t> numbers);

}  // namespace hsp
