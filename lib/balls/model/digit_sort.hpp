// Sorts by digits, the lowest first (Knuth, TAOCP 3, section 5.2.5, algorithm R): each pass is a stable counting sort.
// An entry is a key and a ball, side by side in two numbers, so that a pass writes one stream for each digit; and while
// it moves them it counts those of the next pass, so that it reads them once.
//
// Of two or three digits of many entries the highest is sorted by first, and then the entries of each of its values by
// the others: these are so few that they stay in a near memory. The order is the same.
//
// As an example keys of two decimal digits:
//   given                    21 13 11 23
//   by the lower digit       21 11 13 23      those of one digit stay in their order
//   then by the higher one   11 13 21 23
#pragma once

#include "core/patience.hpp"
#include "core/span.hpp"

namespace hsp {

class DigitSort {
 public:
  // Entries for n balls in each of the two, and at least 4 counters, of which up to 6144 are used.
  DigitSort(Span<uint32_t> entries, Span<uint32_t> other_entries, Span<uint32_t> counters);

  // Passes that tell so many bits apart, in equal parts: two short ones cost less than a short and a long one, whose
  // counters and destinations do not fit the nearest memory.
  struct Passes {
    uint32_t count, bits;
    uint32_t all_bits() const { return count * bits; }
  };
  Passes passes_for(uint32_t bits) const;

  // By so many of the bits of a 32-bit key, above its lowest `others`; balls that these bits do not tell apart stay in
  // their order. First entries() and key_counts() are to be filled, with the number of keys for each value of their
  // first digit: (key >> first_shift()) & mask().
  void begin(uint32_t bits, uint32_t others = 0);
  const Span<uint32_t> &entries() const { return entries_; }
  Span<uint32_t> key_counts() const { return counters_.part(0, mask() + 1); }
  uint32_t first_shift() const { return highest_first_ ? lowest_ + (passes_.count - 1) * passes_.bits : lowest_; }
  uint32_t mask() const { return (UINT32_C(1) << passes_.bits) - 1; }
  // The sorted entries are then in entries(): in the same array as before after an even number of passes. In no order
  // if that is no longer allowed.
  void sort(Patience &patience);
  // The entries are to be in the other array.
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
  uint32_t lowest_ = 0;  // bit of the keys
  Passes passes_{1, 0};
  bool highest_first_ = false;
};

}  // namespace hsp
