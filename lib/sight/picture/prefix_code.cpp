#include "picture/prefix_code.hpp"

#include "core/sorting.hpp"

namespace hsp {
namespace {

// Huffman's tree over counts in ascending order, by two queues: leaves, and pairs in the order in which they are made.
// words[l] becomes the number of leaves of depth l; leaves deeper than `longest` count as of that depth.
void count_depths(Span<const uint32_t> counts, Span<const uint16_t> leaves, uint32_t longest, uint32_t *words) {
  uint32_t weight[PrefixCode::most_symbols];      // of a pair; then its depth
  uint16_t parent[2 * PrefixCode::most_symbols];  // of leaves, then of pairs
  const uint32_t n = leaves.size();
  uint32_t leaf = 0, pair = 0;
  for (uint32_t made = 0; made + 1 < n; ++made) {
    weight[made] = 0;
    for (int side = 0; side < 2; ++side) {
      const bool takes_leaf = leaf < n && (pair == made || counts[leaves[leaf]] <= weight[pair]);
      weight[made] += takes_leaf ? counts[leaves[leaf]] : weight[pair];
      parent[takes_leaf ? leaf++ : n + pair++] = static_cast<uint16_t>(made);
    }
  }
  weight[n - 2] = 0;
  for (uint32_t k = n - 2; k-- > 0;) weight[k] = weight[parent[n + k]] + 1;
  for (uint32_t l = 0; l <= longest; ++l) words[l] = 0;
  for (uint32_t k = 0; k < n; ++k) {
    const uint32_t depth = weight[parent[k]] + 1;
    ++words[depth < longest ? depth : longest];
  }
}

// Lengthens words until their lengths are those of a prefix code. Each time one of the longest words goes beside a
// shorter one, and both get the length of that one plus 1.
void make_room(uint32_t longest, uint32_t *words) {
  uint32_t used = 0;  // of 2^longest
  for (uint32_t l = 1; l <= longest; ++l) used += words[l] << (longest - l);
  for (; used > UINT32_C(1) << longest; --used) {
    uint32_t l = longest - 1;
    while (words[l] == 0) --l;
    --words[l];
    words[l + 1] += 2;
    --words[longest];
  }
}

uint16_t reversed(uint32_t word, uint32_t bits) {
  uint32_t result = 0;
  for (uint32_t k = 0; k < bits; ++k) result |= (word >> k & 1U) << (bits - 1 - k);
  return static_cast<uint16_t>(result);
}

}  // namespace

void PrefixCode::make(Span<const uint32_t> counts, uint32_t longest) {
  symbols_ = counts.size();
  uint16_t order[most_symbols];
  uint32_t used = 0;
  for (uint32_t s = 0; s < symbols_; ++s) {
    length_[s] = 0;
    if (counts[s] > 0) order[used++] = static_cast<uint16_t>(s);
  }
  uint32_t words[longest_word + 1] = {};
  const Span<uint16_t> leaves(order, used);
  if (used == 1) {
    words[1] = 1;
  } else if (used > 1) {
    sort_in_place(leaves,
                  [&](uint16_t a, uint16_t b) { return counts[a] != counts[b] ? counts[a] < counts[b] : a < b; });
    count_depths(counts, leaves, longest, words);
    make_room(longest, words);
  }
  // The rarest symbols get the longest words.
  uint32_t next = 0;
  for (uint32_t l = longest; l > 0; --l) {
    for (uint32_t k = 0; k < words[l]; ++k) length_[leaves[next++]] = static_cast<uint8_t>(l);
  }
  number_words(words);
}

// A fault of g++ 12 for Arm's 64-bit processors: it leaves out calls of functions that write to nothing but an object
// of the caller, if its optimization of induction variables has made a difference of the object's address. This is the
// one such function.
#if defined(__aarch64__) && !defined(__clang__)
[[gnu::optimize("no-ivopts")]]
#endif
void PrefixCode::number_words(const uint32_t *words_of_length) {
  uint32_t next[longest_word + 1] = {};
  for (uint32_t l = 1; l < longest_word; ++l) next[l + 1] = (next[l] + words_of_length[l]) << 1;
  for (uint32_t s = 0; s < symbols_; ++s) {
    word_[s] = length_[s] == 0 ? uint16_t{0} : reversed(next[length_[s]]++, length_[s]);
  }
}

}  // namespace hsp
