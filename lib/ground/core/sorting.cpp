#include "core/sorting.hpp"

#include "core/small_code.hpp"

namespace hsp {

// Quicksort around the median of three. The smaller part goes on and the larger one waits, so that few do; where parts
// are cut badly too often they are left to sort_in_place.
void sort_ascending(Span<uint32_t> numbers) {
  const auto less = [](uint32_t a, uint32_t b) { return a < b; };
  if (small_code || numbers.size() < 24) return sort_in_place(numbers, less);
  constexpr uint32_t most_waiting = 16;
  Span<uint32_t> waiting[most_waiting];
  uint32_t waits = 0;
  uint64_t left = 40 * uint64_t{numbers.size()};  // numbers to compare
  for (Span<uint32_t> part = numbers;;) {
    const uint32_t n = part.size();
    if (n < 24 || n > left || waits == most_waiting) {
      sort_in_place(part, less);
      if (waits == 0) return;
      part = waiting[--waits];
      continue;
    }
    left -= n;
    uint32_t low = part[0], pivot = part[n / 2], high = part[n - 1];
    sort_three(low, pivot, high);
    uint32_t i = 0, j = n - 1;
    for (;; ++i, --j) {
      while (part[i] < pivot) ++i;
      while (pivot < part[j]) --j;
      if (i >= j) break;
      const uint32_t smaller = part[j];
      part[j] = part[i];
      part[i] = smaller;
    }
    const Span<uint32_t> below = part.part(0, j + 1), above = part.part(j + 1, n);
    const bool below_waits = below.size() > above.size();
    waiting[waits++] = below_waits ? below : above;
    part = below_waits ? above : below;
  }
}

}  // namespace hsp
