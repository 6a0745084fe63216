// Stable sorts by keys of any length, with as few counters as are allowed and with more than are used.
#include "model/digit_sort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "random_balls.hpp"

namespace {

hsp::Span<uint32_t> span_of(std::vector<uint32_t> &entries) {
  return {entries.data(), static_cast<uint32_t>(entries.size())};
}

// By `bits` bits of keys that have `others` more below them.
void expect_sorted(oracle::RandomSource &random, uint32_t n, uint32_t bits, uint32_t others, uint32_t counters) {
  std::vector<uint32_t> entries(2 * n), other_entries(2 * n), counts(counters);
  hsp::DigitSort sort(span_of(entries), span_of(other_entries), span_of(counts));
  sort.begin(bits, others);
  ASSERT_GE(sort.passes_for(bits).all_bits(), bits);
  std::vector<std::pair<uint32_t, uint32_t>> expected, found;
  for (uint32_t k = 0; k < n; ++k) {
    const uint32_t key = static_cast<uint32_t>(random.in(0, (int64_t{1} << (bits + others)) - 1));
    expected.emplace_back(key, k);
    sort.entries()[2 * k] = key;
    sort.entries()[2 * k + 1] = k;
    ++sort.key_counts()[(key >> sort.first_shift()) & sort.mask()];
  }
  hsp::Patience patience;
  sort.sort(patience);
  for (uint32_t k = 0; k < n; ++k) found.emplace_back(sort.entries()[2 * k], sort.entries()[2 * k + 1]);
  std::stable_sort(expected.begin(), expected.end(), [others](const auto &a, const auto &b) {
    return uint64_t{a.first} >> others < uint64_t{b.first} >> others;
  });
  EXPECT_EQ(found, expected) << n << " keys of " << bits << " of " << bits + others << " bits, " << counters
                             << " counters";
  const bool even = sort.passes_for(bits).count % 2 == 0;
  EXPECT_EQ(sort.entries().data(), even ? entries.data() : other_entries.data());
}

TEST(DigitSort, IsStable) {
  oracle::RandomSource random(23);
  for (uint32_t bits = 0; bits <= 32; ++bits) {
    for (const uint32_t n : {0U, 1U, 2U, 40U, 3000U}) {
      for (const uint32_t counters : {4U, 7U, 64U, 5000U}) {
        expect_sorted(random, n, bits, 0, counters);
        expect_sorted(random, n, bits, (32 - bits) / 2, counters);
        expect_sorted(random, n, bits, bits == 0 ? 31 : 32 - bits, counters);
      }
    }
  }
}

// The highest of two digits comes first if there are very many entries, and few for each pair of digits make it last.
TEST(DigitSort, OfManyEntriesIsStable) {
  oracle::RandomSource random(29);
  for (const uint32_t bits : {12U, 14U, 16U, 17U, 18U}) {
    for (const uint32_t others : {0U, 5U}) expect_sorted(random, 270000, bits, others, 5000);
  }
}

}  // namespace
