// Prefix codes as Deflate has them (RFC 1951, section 3.2.2): given by the lengths of their words alone.
#pragma once

#include <cstdint>

#include "core/span.hpp"

namespace hsp {

class PrefixCode {
 public:
  static constexpr uint32_t most_symbols = 286;
  static constexpr uint32_t longest_word = 15;

  // For symbols that come so often; one that does not come has no word. No word has more than `longest` bits, of which
  // there have to be enough for all symbols: as few bits in all as Huffman's code takes, unless that is cut.
  void make(Span<const uint32_t> counts, uint32_t longest);

  uint32_t symbols() const { return symbols_; }
  // 0: no word.
  uint32_t length(uint32_t symbol) const { return length_[symbol]; }
  // Its first bit lowest, as Deflate writes words.
  uint32_t word(uint32_t symbol) const { return word_[symbol]; }

 private:
  void number_words(const uint32_t *words_of_length);

  uint32_t symbols_ = 0;
  uint8_t length_[most_symbols];
  uint16_t word_[most_symbols];
};

}  // namespace hsp
