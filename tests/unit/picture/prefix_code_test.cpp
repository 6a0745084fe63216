// Against Huffman's algorithm with a heap of the standard library.
#include "picture/prefix_code.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <queue>
#include <vector>

#include "random_balls.hpp"

namespace {

using Counts = std::vector<uint32_t>;

hsp::PrefixCode code_of(Counts &counts, uint32_t longest) {
  hsp::PrefixCode code;
  code.make({counts.data(), static_cast<uint32_t>(counts.size())}, longest);
  return code;
}

// Bits of all words in the best code of all.
uint64_t fewest_bits(const Counts &counts) {
  std::priority_queue<uint64_t, std::vector<uint64_t>, std::greater<>> weights;
  for (const uint32_t count : counts) {
    if (count > 0) weights.push(count);
  }
  if (weights.size() == 1) return weights.top();
  uint64_t bits = 0;
  while (weights.size() > 1) {
    uint64_t pair = weights.top();
    weights.pop();
    pair += weights.top();
    weights.pop();
    bits += pair;
    weights.push(pair);
  }
  return bits;
}

uint64_t bits_of(const hsp::PrefixCode &code, const Counts &counts) {
  uint64_t bits = 0;
  for (uint32_t s = 0; s < counts.size(); ++s) bits += uint64_t{counts[s]} * code.length(s);
  return bits;
}

// No word begins with another one, each symbol that comes has one of at most so many bits, and no words are to spare.
void expect_prefix_code(const hsp::PrefixCode &code, const Counts &counts, uint32_t longest) {
  ASSERT_EQ(code.symbols(), counts.size());
  uint32_t used = 0;
  uint64_t share = 0;  // of 2^longest
  for (uint32_t s = 0; s < counts.size(); ++s) {
    ASSERT_EQ(code.length(s) > 0, counts[s] > 0);
    ASSERT_LE(code.length(s), longest);
    if (counts[s] == 0) continue;
    ++used;
    share += uint64_t{1} << (longest - code.length(s));
    ASSERT_LT(code.word(s), 1U << code.length(s));
    for (uint32_t t = 0; t < s; ++t) {
      if (counts[t] == 0) continue;
      const uint32_t common = std::min(code.length(s), code.length(t));
      ASSERT_NE(code.word(s) & ((1U << common) - 1), code.word(t) & ((1U << common) - 1)) << s << ' ' << t;
    }
  }
  const uint64_t all = used == 0 ? 0 : used == 1 ? uint64_t{1} << (longest - 1) : uint64_t{1} << longest;
  EXPECT_EQ(share, all);
}

TEST(PrefixCode, TakesAsFewBitsAsHuffmansCode) {
  oracle::RandomSource random(11);
  for (int k = 0; k < 400; ++k) {
    Counts counts(static_cast<size_t>(random.in(1, 286)));
    const int64_t most = random.one_in(3) ? 3 : 300;
    for (uint32_t &count : counts) count = static_cast<uint32_t>(random.one_in(3) ? 0 : random.in(0, most));
    const hsp::PrefixCode code = code_of(counts, 15);
    expect_prefix_code(code, counts, 15);
    EXPECT_EQ(bits_of(code, counts), fewest_bits(counts));
  }
}

TEST(PrefixCode, OfCountsThatAskForLongWords) {
  // Each as often as all before: words of all lengths, up to the number of symbols less one.
  for (const uint32_t longest : {7U, 15U}) {
    for (uint32_t symbols = 2; symbols <= 19; ++symbols) {
      Counts counts(symbols, 1);
      for (uint32_t s = 2; s < symbols; ++s) counts[s] = counts[s - 1] + counts[s - 2];
      const hsp::PrefixCode code = code_of(counts, longest);
      expect_prefix_code(code, counts, longest);
      if (symbols <= longest + 1) {
        EXPECT_EQ(bits_of(code, counts), fewest_bits(counts));
      } else {
        EXPECT_LE(static_cast<double>(bits_of(code, counts)), 1.15 * static_cast<double>(fewest_bits(counts)));
      }
    }
  }
}

TEST(PrefixCode, OfNoSymbolAndOfOne) {
  Counts none(30, 0), one(30, 0);
  one[7] = 5;
  expect_prefix_code(code_of(none, 15), none, 15);
  const hsp::PrefixCode code = code_of(one, 15);
  expect_prefix_code(code, one, 15);
  EXPECT_EQ(code.length(7), 1U);
  EXPECT_EQ(code.word(7), 0U);
}

// The example of RFC 1951, section 3.2.2, its words with the first bit lowest.
TEST(PrefixCode, NumbersWordsAsDeflateDoes) {
  Counts counts = {3, 3, 3, 3, 3, 6, 2, 2};
  const hsp::PrefixCode code = code_of(counts, 15);
  const std::vector<uint32_t> length = {3, 3, 3, 3, 3, 2, 4, 4};
  const std::vector<uint32_t> word = {0b010, 0b110, 0b001, 0b101, 0b011, 0b00, 0b0111, 0b1111};
  for (uint32_t s = 0; s < 8; ++s) {
    EXPECT_EQ(code.length(s), length[s]) << s;
    EXPECT_EQ(code.word(s), word[s]) << s;
  }
}

}  // namespace
