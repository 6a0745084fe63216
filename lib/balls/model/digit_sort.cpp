#include "model/digit_sort.hpp"

#include <cstring>

#include "core/small_code.hpp"

namespace hsp {
namespace {

constexpr uint32_t more_than_near = UINT32_C(1) << 18;  // entries

// Turns the number of entries with each digit into the slot of the first of these entries.
void add_up(const Span<uint32_t> &counts) {
  uint32_t slot = 0;
  for (uint32_t &count : counts) {
    const uint32_t here = count;
    count = slot;
    slot += here;
  }
}

// One pass: moves n entries to their slots by the digit at `shift`.
void move_entries(const uint32_t *from, uint32_t n, uint32_t shift, uint32_t mask, uint32_t *slots, uint32_t *to) {
  for (uint32_t k = 0; k < n; ++k, from += 2) {
    uint64_t entry;
    std::memcpy(&entry, from, sizeof entry);
    const uint32_t at = slots[(*from >> shift) & mask]++;
    std::memcpy(to + 2 * static_cast<size_t>(at), &entry, sizeof entry);
  }
}

}  // namespace

DigitSort::DigitSort(Span<uint32_t> entries, Span<uint32_t> other_entries, Span<uint32_t> counters)
    : entries_(entries), other_entries_(other_entries), counters_(counters) {
  while (most_bits_ < 11 && UINT32_C(4) << most_bits_ <= counters_.size()) ++most_bits_;
}

DigitSort::Passes DigitSort::passes_for(uint32_t bits) const {
  const uint32_t count = bits == 0 ? 1 : (bits + most_bits_ - 1) / most_bits_;
  return {count, (bits + count - 1) / count};
}

void DigitSort::begin(uint32_t bits, uint32_t others) {
  lowest_ = others;
  passes_ = passes_for(bits);
  // For each value of the highest digit the counters of the other digits are made 0 and summed. This costs more than it
  // saves, unless there are twice as many entries for each value. For two passes it pays only if the entries do not
  // stay in a near cache.
  const uint64_t entries = entries_.size() / 2, counters_of_others = uint64_t{passes_.count - 1} << passes_.bits;
  highest_first_ = !small_code && (passes_.count == 3 || (passes_.count == 2 && entries >= more_than_near)) &&
                   uint64_t{passes_.count} << passes_.bits <= counters_.size() &&
                   entries >= 2 * counters_of_others << passes_.bits;
  for (uint32_t &count : key_counts()) count = 0;
}

void DigitSort::sort(Patience &patience) {
  if (highest_first_) {
    sort_highest_first(patience);
  } else {
    sort_lowest_first(patience);
  }
}

void DigitSort::sort_highest_first(Patience &patience) {
  const Span<uint32_t> slots = key_counts();
  add_up(slots);
  move_entries(entries_.data(), entries_.size() / 2, first_shift(), mask(), slots.data(), other_entries_.data());
  exchange();
  uint32_t first = 0;
  for (const uint32_t last : slots) {
    if (!patience.allows(100 * uint64_t{last - first})) return;
    if (first < last) {
      if (passes_.count == 2) {
        sort_by_lowest_digit(first, last);
      } else {
        sort_by_two_digits(first, last);
      }
    }
    first = last;
  }
  if (passes_.count == 2) exchange();
}

// Sorts entries first .. last - 1 into the same slots of the other array.
void DigitSort::sort_by_lowest_digit(uint32_t first, uint32_t last) {
  const Span<uint32_t> slots = counters_.part(mask() + 1, 2 * (mask() + 1));
  for (uint32_t &count : slots) count = 0;
  const uint32_t *const entries = entries_.part(2 * first, 2 * last).data();
  for (uint32_t k = 0; k < last - first; ++k) ++slots[(entries[2 * static_cast<size_t>(k)] >> lowest_) & mask()];
  add_up(slots);
  move_entries(entries, last - first, lowest_, mask(), slots.data(), other_entries_.part(2 * first, 2 * last).data());
}

// Sorts entries first .. last - 1, by the front of the other array: always the same memory, which stays in a near
// cache.
void DigitSort::sort_by_two_digits(uint32_t first, uint32_t last) {
  const uint32_t low_shift = lowest_, high_shift = lowest_ + passes_.bits, mask = this->mask(), values = mask + 1;
  const Span<uint32_t> low = counters_.part(values, 2 * values), high = counters_.part(2 * values, 3 * values);
  for (uint32_t &count : counters_.part(values, 3 * values)) count = 0;
  uint32_t *const entries = entries_.part(2 * first, 2 * last).data();
  uint32_t *const others = other_entries_.part(0, 2 * (last - first)).data();
  for (uint32_t k = 0; k < last - first; ++k) {
    const uint32_t key = entries[2 * static_cast<size_t>(k)];
    ++low[(key >> low_shift) & mask];
    ++high[(key >> high_shift) & mask];
  }
  add_up(low);
  add_up(high);
  move_entries(entries, last - first, low_shift, mask, low.data(), others);
  move_entries(others, last - first, high_shift, mask, high.data(), entries);
}

void DigitSort::sort_lowest_first(Patience &patience) {
  const uint32_t n = entries_.size() / 2;
  const uint32_t mask = this->mask();
  Span<uint32_t> slots = counters_.part(0, mask + 1);
  Span<uint32_t> next = counters_.part(mask + 1, 2 * (mask + 1));
  for (uint32_t p = 0; p < passes_.count && patience.allows(20 * uint64_t{n}); ++p) {
    add_up(slots);
    for (uint32_t &count : next) count = 0;
    const uint32_t shift = lowest_ + p * passes_.bits;
    // The last pass counts in vain: a loop of its own without counting would cost more.
    const uint32_t next_shift = p + 1 < passes_.count ? shift + passes_.bits : shift;
    const uint32_t *from = entries_.data();
    uint32_t *const to = other_entries_.data();
    for (uint32_t k = 0; k < n; ++k, from += 2) {
      const uint32_t key = *from;
      uint64_t entry;
      std::memcpy(&entry, from, sizeof entry);
      const uint32_t at = slots[(key >> shift) & mask]++;
      std::memcpy(to + 2 * static_cast<size_t>(at), &entry, sizeof entry);
      ++next[(key >> next_shift) & mask];
    }
    const Span<uint32_t> counted = next;
    next = slots;
    slots = counted;
    exchange();
  }
}

}  // namespace hsp
