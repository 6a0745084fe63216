#include "model/digit_sort.hpp"

#include <cstring>

namespace hsp {

DigitSort::DigitSort(Span<uint32_t> entries, Span<uint32_t> other_entries, Span<uint32_t> counters)
    : entries_(entries), other_entries_(other_entries), counters_(counters) {
  while (most_bits_ < 11 && UINT32_C(4) << most_bits_ <= counters_.size()) ++most_bits_;
}

DigitSort::Passes DigitSort::passes_for(uint32_t bits) const {
  const uint32_t count = bits == 0 ? 1 : (bits + most_bits_ - 1) / most_bits_;
  return {count, (bits + count - 1) / count};
}

void DigitSort::begin(uint32_t bits) {
  passes_ = passes_for(bits);
  for (uint32_t &count : key_counts()) count = 0;
}

void DigitSort::sort() {
  const uint32_t n = entries_.size() / 2;
  const uint32_t mask = this->mask();
  uint32_t *places = counters_.data();
  uint32_t *next = places + mask + 1;
  for (uint32_t p = 0; p < passes_.count; ++p) {
    uint32_t place = 0;
    for (uint32_t value = 0; value <= mask; ++value) {
      const uint32_t count = places[value];
      places[value] = place;
      place += count;
      next[value] = 0;
    }
    const uint32_t shift = p * passes_.bits;
    // Those of the last pass are counted in vain: one more way through here would cost more.
    const uint32_t next_shift = p + 1 < passes_.count ? shift + passes_.bits : shift;
    const uint32_t *from = entries_.data();
    uint32_t *const to = other_entries_.data();
    for (uint32_t k = 0; k < n; ++k, from += 2) {
      const uint32_t key = *from;
      uint64_t entry;
      std::memcpy(&entry, from, sizeof entry);
      const uint32_t at = places[(key >> shift) & mask]++;
      std::memcpy(to + 2 * static_cast<size_t>(at), &entry, sizeof entry);
      ++next[(key >> next_shift) & mask];
    }
    uint32_t *const counted = next;
    next = places;
    places = counted;
    exchange();
  }
}

}  // namespace hsp
