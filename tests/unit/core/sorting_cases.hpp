// Sorting: sorted, and the same items as before, for all lengths around the change of method.
#pragma once

#include "cases.hpp"
#include "core/sorting.hpp"

namespace cases {

struct ToSort {
  uint32_t length, different;  // items, and how many different values they have
  bool ascending, descending;  // already
};
constexpr ToSort to_sort[] = {
    {0, 1, false, false},     {1, 1, false, false},    {2, 2, false, true},     {2, 2, true, false},
    {3, 2, false, false},     {22, 22, false, false},  {23, 23, false, true},   {23, 23, true, false},
    {23, 4, false, false},    {24, 24, false, false},  {24, 24, true, false},   {24, 24, false, true},
    {24, 3, false, false},    {25, 25, false, false},  {25, 1, false, false},   {64, 64, false, false},
    {199, 100, false, false}, {200, 200, true, false}, {200, 200, false, true}, {200, 7, false, false}};

// sort(items, scratch) sorts them in ascending order.
template <class Sort>
uint32_t sorted_whatever_the_length(Sort sort) {
  return first_failing(to_sort, [sort](const ToSort &c) {
    uint32_t items[200], times[200] = {};
    Random random(c.length + c.different);
    for (uint32_t k = 0; k < c.length; ++k) {
      items[k] = c.ascending ? k : c.descending ? c.length - 1 - k : random.below(c.different);
      ++times[items[k]];
    }
    uint32_t scratch[200];
    sort(hsp::Span<uint32_t>(items, c.length), hsp::Span<uint32_t>(scratch, c.length));
    for (uint32_t k = 0; k < c.length; ++k) {
      if (k > 0 && items[k] < items[k - 1]) return false;
      --times[items[k]];
    }
    for (const uint32_t rest : times) {
      if (rest != 0) return false;
    }
    return true;
  });
}

constexpr auto ascending = [](uint32_t a, uint32_t b) { return a < b; };

inline uint32_t sorted_in_place() {
  return sorted_whatever_the_length(
      [](hsp::Span<uint32_t> items, hsp::Span<uint32_t>) { hsp::sort_in_place(items, ascending); });
}

// Also numbers of which sort_ascending takes off two at a time: the median of the first, the middle and the last one is
// the second of all, and what is left is such a list again.
inline uint32_t sorted_ascending() {
  const bool short_ones = sorted_whatever_the_length([](hsp::Span<uint32_t> items, hsp::Span<uint32_t>) {
                            hsp::sort_ascending(items);
                          }) == all_hold;
  constexpr uint32_t n = 1000;
  uint32_t taken_off[n] = {};
  for (uint32_t size = 0; size < n; size += 2) {
    const uint32_t begin = n - size - 2, middle = (size + 2) / 2;
    taken_off[begin] = begin;
    taken_off[begin + 1] = taken_off[begin + middle];
    taken_off[begin + middle] = begin + 1;
  }
  const auto is_sorted = [](auto number_of) {
    uint32_t items[n], expected[n];
    for (uint32_t k = 0; k < n; ++k) items[k] = expected[k] = number_of(k);
    hsp::sort_in_place(hsp::Span<uint32_t>(expected, n), ascending);
    hsp::sort_ascending(hsp::Span<uint32_t>(items, n));
    for (uint32_t k = 0; k < n; ++k) {
      if (items[k] != expected[k]) return false;
    }
    return true;
  };
  const bool all = is_sorted([](uint32_t k) { return k * 2654435761U; }) &&
                   is_sorted([](uint32_t k) { return k * 2654435761U >> 31; }) &&
                   is_sorted([](uint32_t k) { return k < n / 2 ? k : n - k; }) &&
                   is_sorted([&](uint32_t k) { return taken_off[k]; });
  return short_ones && all ? all_hold : 0;
}

// Hints about the slots of every kind: the truth, nothing, nearly the truth, the opposite.
inline uint32_t sorted_by_slot() {
  struct Guess {
    uint32_t (*place)(uint32_t item, uint32_t slots);
  };
  constexpr Guess guesses[] = {{[](uint32_t item, uint32_t slots) { return item * slots / 200; }},
                               {[](uint32_t, uint32_t) { return UINT32_C(0); }},
                               {[](uint32_t, uint32_t slots) { return slots - 1; }},
                               {[](uint32_t item, uint32_t slots) { return (item ^ 8U) * slots / 210; }},
                               {[](uint32_t item, uint32_t slots) { return slots - 1 - item * slots / 200; }}};
  return first_failing(guesses, [](const Guess &guess) {
    return sorted_whatever_the_length([&guess](hsp::Span<uint32_t> items, hsp::Span<uint32_t> scratch) {
             hsp::sort_by_slot(items, scratch, guess.place, ascending);
           }) == all_hold;
  });
}

// With few slots and no more scratch memory than these need, and as long as it may go on.
inline uint32_t sorted_by_few_slots() {
  constexpr uint32_t counts[] = {1, 2, 7, 50, 99};
  return first_failing(counts, [](uint32_t slots) {
    uint32_t asked = 0;
    const auto sort = [&](hsp::Span<uint32_t> items, hsp::Span<uint32_t> scratch, uint32_t most) {
      const auto slot_of = [slots](uint32_t item) { return item * slots / 200; };
      hsp::sort_by_slot(items, scratch.part(0, 2 * slots + 1), slots, slot_of, ascending,
                        [&] { return asked++ < most; });
    };
    const bool sorted = sorted_whatever_the_length([&](hsp::Span<uint32_t> items, hsp::Span<uint32_t>) {
                          uint32_t scratch[200];
                          sort(items, hsp::Span<uint32_t>(scratch, 200), ~UINT32_C(0));
                        }) == all_hold;
    uint32_t items[3] = {150, 100, 50}, scratch[200];
    asked = 0;
    sort(hsp::Span<uint32_t>(items, 3), hsp::Span<uint32_t>(scratch, 200), 2);
    return sorted && asked == 3 && items[0] == 150;
  });
}

// By numbers that follow the order, are all the same, or follow another one.
inline uint32_t sorted_by_number() {
  struct Guess {
    double (*number)(uint32_t item);
  };
  constexpr Guess guesses[] = {{[](uint32_t item) { return item - 90.5; }},
                               {[](uint32_t) { return -1e300; }},
                               {[](uint32_t item) { return -1e300 * (item % 7); }}};
  return first_failing(guesses, [](const Guess &guess) {
    return sorted_whatever_the_length([&guess](hsp::Span<uint32_t> items, hsp::Span<uint32_t> scratch) {
             hsp::sort_by_number(items, scratch, guess.number, ascending);
           }) == all_hold;
  });
}

// The comparison alone decides: here larger items come first.
inline uint32_t sorted_by_the_given_order() {
  int items[30];
  for (int k = 0; k < 30; ++k) items[k] = k * 7 % 30;
  hsp::sort_in_place(hsp::Span<int>(items, 30), [](int a, int b) { return a > b; });
  for (uint32_t k = 0; k < 30; ++k) {
    if (items[k] != 29 - static_cast<int>(k)) return k;
  }
  return all_hold;
}

// All orders of three, also with equal ones, which are never exchanged.
inline uint32_t three_sorted() {
  constexpr uint32_t orders[][3] = {{1, 2, 3}, {2, 3, 1}, {3, 1, 2}, {1, 3, 2}, {3, 2, 1}, {2, 1, 3},
                                    {1, 1, 2}, {1, 2, 1}, {2, 1, 1}, {2, 2, 1}, {2, 1, 2}, {1, 1, 1}};
  return first_failing(orders, [](const uint32_t(&given)[3]) {
    uint32_t item[3] = {given[0], given[1], given[2]};
    uint32_t inversions = 0;
    for (uint32_t k = 0; k < 3; ++k) {
      for (uint32_t j = 0; j < k; ++j) inversions += given[j] > given[k] ? 1U : 0U;
    }
    const bool odd = hsp::sort_three(item[0], item[1], item[2]);
    uint32_t digits = 0;
    for (const uint32_t each : given) digits += each == 1 ? 1U : each == 2 ? 10U : 100U;
    for (const uint32_t each : item) digits -= each == 1 ? 1U : each == 2 ? 10U : 100U;
    return item[0] <= item[1] && item[1] <= item[2] && digits == 0 && odd == (inversions % 2 == 1);
  });
}

// A heap of items that know their places, in which keys go up and down: each item is where it was put last, and the
// first one has the largest key.
inline uint32_t places_in_a_heap() {
  constexpr uint32_t items = 40, changes = 2000;
  uint32_t key[items], place[items], heap[items];
  const auto less = [&](uint32_t a, uint32_t b) { return key[a] < key[b]; };
  const auto placed = [&](uint32_t item, uint32_t slot) { place[item] = slot; };
  Random random(7);
  for (uint32_t k = 0; k < items; ++k) {
    key[k] = random.below(30);
    heap[k] = k;
    hsp::sift_up(hsp::Span<uint32_t>(heap, k + 1), k, less, placed);
  }
  for (uint32_t change = 0; change < changes; ++change) {
    const uint32_t item = random.below(items), before = key[item];
    key[item] = random.below(30);
    const hsp::Span<uint32_t> all(heap, items);
    if (key[item] > before) {
      hsp::sift_up(all, place[item], less, placed);
    } else {
      hsp::sift_down(all, place[item], less, placed);
    }
    for (uint32_t k = 0; k < items; ++k) {
      if (heap[place[k]] != k || key[k] > key[heap[0]]) return change;
    }
  }
  return all_hold;
}

inline constexpr Check core_sorting[] = {
    {"sorted_in_place", sorted_in_place},   {"sorted_ascending", sorted_ascending},
    {"sorted_by_slot", sorted_by_slot},     {"sorted_by_few_slots", sorted_by_few_slots},
    {"sorted_by_number", sorted_by_number}, {"sorted_by_the_given_order", sorted_by_the_given_order},
    {"three_sorted", three_sorted},         {"places_in_a_heap", places_in_a_heap}};

}  // namespace cases
