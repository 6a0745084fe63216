// Radix sort: sorts by digits, the lowest first (Knuth, TAOCP 3, section 5.2.5, algorithm R). Each pass is a stable
// counting sort. An entry is a key and a ball, side by side in two numbers, so that a pass writes one stream for each
// value of the digit. While a pass moves entries it counts the digits for the next pass, so that it reads them once.
//
// Many entries of two or three digits are sorted by the highest digit first, and then the entries of each value of that
// digit by the others: these are so few that they stay in a near cache. The result is the same.
//
// As an example keys of two decimal digits:
//   given                    21 13 11 23
//   by the lower digit       21 11 13 23      entries with the same digit stay in their order
//   then by the higher one   11 13 21 23
#pragma once

#include "core/patience.hpp"
#include "core/span.hpp"

namespace hsp {

class DigitSort {
 public:
  // Two arrays of entries for n balls each, and at least 4 counters, of which up to 6144 are used.
  DigitSort(Span<uint32_t> entries, Span<uint32_t> other_entries, Span<uint32_t> counters);

  // The passes for so many bits, with equally many bits each: two short passes cost less than a short and a long one,
  // as the counters and destinations of a long pass do not fit the nearest cache.
  struct Passes {
    uint32_t count, bits;
    uint32_t all_bits() const { return count * bits; }
  };
  Passes passes_for(uint32_t bits) const;

  // Begins a sort by so many bits of a 32-bit key, above its lowest `others`; balls with the same of these bits stay in
  // their order. Then, before sort(), the caller fills entries(), and adds to key_counts() the number of keys for each
  // value of their first digit, (key >> first_shift()) & mask(). begin() makes the counts 0.
  void begin(uint32_t bits, uint32_t others = 0);
  const Span<uint32_t> &entries() const { return entries_; }
  Span<uint32_t> key_counts() const { return counters_.part(0, mask() + 1); }
  uint32_t first_shift() const { return highest_first_ ? lowest_ + (passes_.count - 1) * passes_.bits : lowest_; }
  uint32_t mask() const { return (UINT32_C(1) << passes_.bits) - 1; }
  // Sorts. The sorted entries are then in entries(), which after an even number of passes is the same array as before.
  // If `patience` allows no more work, they are in no order.
  void sort(Patience &patience);
  // Exchanges both arrays of entries.
  void exchange() {
    const Span<uint32_t> entries = entries_;
    entries_ = other_entries_;
    other_entries_ = entries;
  }

 private:
  void sort_lowest_first(Patience &patience);
  void sort_highest_first(Patience &patience);
  void sort_by_two_digits(uint32_t first, uint32_t last);
  void sort_by_lowest_digit(uint32_t first, uint32_t last);

  Span<uint32_t> entries_, other_entries_, counters_;
  uint32_t most_bits_ = 0;
  uint32_t lowest_ = 0;  // the lowest bit of the keys that is sorted by
  Passes passes_{1, 0};
  bool highest_first_ = false;
};

}  // namespace hsp
