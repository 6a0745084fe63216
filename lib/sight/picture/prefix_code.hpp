// Prefix codes as Deflate has them (RFC 1951, section 3.2.2): given by the lengths of their words alone.
#pragma once

#include <cstdint>

#include "core/span.hpp"

namespace hsp {

class PrefixCode {
 public:
  static constexpr uint32_t most_symbols = 286;
  static constexpr uint32_t longest_word = 15;

  // Makes the code for symbols that occur `counts` times; a symbol that does not occur has no word. No word is longer
  // than `longest` bits, which have to suffice for all symbols. The code is Huffman's, unless some of its words are too
  // long.
  void make(Span<const uint32_t> counts, uint32_t longest);

  uint32_t symbols() const { return symbols_; }
  // The bits of a symbol's word; 0: it has none.
  uint32_t length(uint32_t symbol) const { return length_[symbol]; }
  // The word, with its first bit lowest, as Deflate writes words.
  uint32_t word(uint32_t symbol) const { return word_[symbol]; }

 private:
  void number_words(const uint32_t *words_of_length);

  uint32_t symbols_ = 0;
  uint8_t length_[most_symbols];
  uint16_t word_[most_symbols];
};

}  // namespace hsp
