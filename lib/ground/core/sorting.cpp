#include "core/sorting.hpp"

#include "core/small_code.hpp"

namespace hsp {

// Quicksort around the median of three. The smaller part goes on and the larger one waits, so that few do; where parts
// are cut badly too often they are left to sort_in_place.
void sort_ascending(Span<uint32_t> numbers) {
  constexpr uint32_t most_waiting = small_code ? 0 : 16;
  struct Part {
    uint32_t first, last;
  } waiting[16];
  uint32_t waits = 0;
  uint64_t left = 40 * uint64_t{numbers.size()};  // numbers to compare
  for (Part all = {0, numbers.size()};;) {
    const Span<uint32_t> part = numbers.part(all.first, all.last);
    const uint32_t n = part.size();
    if (n < 24 || n > left || waits == most_waiting) {
      sort_in_place(part, [](uint32_t a, uint32_t b) { return a < b; });
      if (waits == 0) return;
      all = waiting[--waits];
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
    const uint32_t cut = all.first + j + 1;
    const bool below_waits = 2 * (j + 1) > n;
    waiting[waits++] = below_waits ? Part{all.first, cut} : Part{cut, all.last};
    (below_waits ? all.first : all.last) = cut;
  }
}

}  // namespace hsp
