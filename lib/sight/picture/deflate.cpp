#include "picture/deflate.hpp"

#include <bit>

namespace hsp {
namespace {

// Positions looked at for a repeat.
constexpr uint32_t most_tries = 48;

// Of Adler's checksum, a sum below twice this prime modulo the prime.
constexpr uint32_t adler = 65521;
uint32_t below(uint32_t prime, uint32_t sum) {
  return sum < prime ? sum : sum - prime;
}

// A block begins with the lengths of its words, in a code of their own: 0 to 15, and three symbols for runs.
constexpr uint32_t last_again = 16, few_zeros = 17, many_zeros = 18, length_symbols = 19;
constexpr uint32_t longest_length_word = 7;
constexpr uint8_t length_order[length_symbols] = {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};

// Lengths of words as symbols of that code: calls put(symbol, rest, bits of it).
template <class Put>
void visit_lengths(Span<const uint8_t> length, Put put) {
  for (uint32_t k = 0; k < length.size();) {
    uint32_t run = 1;
    while (k + run < length.size() && length[k + run] == length[k]) ++run;
    const uint32_t value = length[k];
    k += run;
    if (value != 0) {
      put(value, 0U, 0U);
      --run;
    }
    while (run >= 3) {
      const uint32_t most = value != 0 ? 6 : 138;
      const uint32_t part = run < most ? run : most;
      if (value != 0) {
        put(last_again, part - 3, 2U);
      } else if (part <= 10) {
        put(few_zeros, part - 3, 3U);
      } else {
        put(many_zeros, part - 11, 7U);
      }
      run -= part;
    }
    for (; run > 0; --run) put(value, 0U, 0U);
  }
}

}  // namespace

void Deflater::carve(Workspace &workspace) {
  ring_ = workspace.take<uint8_t>(ring);
  back_ = workspace.take<uint16_t>(window);
  last_ = workspace.take<uint32_t>(1U << hash_bits);
  item_ = workspace.take<uint32_t>(block);
  out_ = workspace.take<char>(out_bytes);
  count_ = workspace.take<uint32_t>(lengths);
  header_ = workspace.take<uint32_t>(lengths + 32);
  // Nothing is in reach of the first byte.
  for (uint32_t &position : last_) position = 0U - 2 * window;
  // Deflate with this window; a check that makes it a multiple of 31; no more than that.
  const uint32_t method = (window_bits - 8) << 4 | 8U;
  const uint32_t level = 2U << 6;
  pending_ = method | static_cast<uint64_t>(level + 31 - (method << 8 | level) % 31) << 8;
  used_bits_ = 16;
}

size_t Deflater::receive(const char *bytes, size_t count) {
  const uint32_t room = window - (received_ - done_);
  const uint32_t taken = count < room ? static_cast<uint32_t>(count) : room;
  for (uint32_t k = 0; k < taken; ++k) {
    const uint8_t value = static_cast<uint8_t>(bytes[k]);
    ring_[received_++ % ring] = value;
    low_sum_ = below(adler, low_sum_ + value);
    high_sum_ = below(adler, high_sum_ + low_sum_);
  }
  return taken;
}

uint32_t Deflater::hash(uint32_t at) const {
  return ((byte(at) | byte(at + 1) << 8 | byte(at + 2) << 16) * 2654435761U) >> (32 - hash_bits);
}

void Deflater::remember(uint32_t at) {
  if (received_ - at < least_repeated) return;
  uint32_t &last = last_[hash(at)];
  const uint32_t distance = at - last;
  back_[at % window] = distance <= window ? static_cast<uint16_t>(distance) : uint16_t{0};
  last = at;
}

Deflater::Repeat Deflater::longest_repeat(uint32_t at) const {
  Repeat best{0, 0};
  const uint32_t ahead = received_ - at, most = ahead < most_repeated ? ahead : most_repeated;
  if (most < least_repeated) return best;
  uint32_t position = last_[hash(at)];
  for (uint32_t tries = 0; tries < most_tries && at - position <= window; ++tries) {
    uint32_t length = 0;
    while (length < most && byte(position + length) == byte(at + length)) ++length;
    if (length > best.length) best = {length, at - position};
    const uint32_t step = back_[position % window];
    if (length == most || step == 0) break;
    position -= step;
  }
  return best;
}

void Deflater::advance() {
  Repeat here = longest_repeat(done_);
  remember(done_);
  while (here.length >= least_repeated && here.length < good_length && received_ - done_ > 1) {
    const Repeat next = longest_repeat(done_ + 1);
    if (next.length <= here.length) break;
    push(byte(done_++));
    remember(done_);
    here = next;
  }
  if (here.length < least_repeated) {
    push(byte(done_++));
    return;
  }
  push(here.length << 16 | here.distance);
  for (uint32_t k = 1; k < here.length; ++k) remember(done_ + k);
  done_ += here.length;
}

Deflater::Placed Deflater::placed_length(uint32_t length) {
  if (length == most_repeated) return {285, {0, 0}};
  const uint32_t n = length - least_repeated;
  if (n < 8) return {257 + n, {0, 0}};
  const uint32_t bits = static_cast<uint32_t>(std::bit_width(n)) - 3;
  return {257 + 4 * bits + (n >> bits), {n & ((1U << bits) - 1), bits}};
}

Deflater::Placed Deflater::placed_distance(uint32_t distance) {
  const uint32_t n = distance - 1;
  if (n < 4) return {n, {0, 0}};
  const uint32_t bits = static_cast<uint32_t>(std::bit_width(n)) - 2;
  return {2 * bits + (n >> bits), {n & ((1U << bits) - 1), bits}};
}

void Deflater::make_codes(bool last) {
  for (uint32_t &count : count_) count = 0;
  ++count_[end_of_block];
  for (uint32_t k = 0; k < items_; ++k) {
    const Item item = item_[k];
    if (item < 256) {
      ++count_[item];
    } else {
      ++count_[placed_length(item >> 16).symbol];
      ++count_[literals + placed_distance(item & 0xFFFFU).symbol];
    }
  }
  literal_code_.make(count_.part(0, literals), PrefixCode::longest_word);
  distance_code_.make(count_.part(literals, lengths), PrefixCode::longest_word);
  // The lengths of all symbols are written, used or not: runs of zeros take few bits.
  uint8_t length_of[lengths];
  for (uint32_t s = 0; s < literals; ++s) length_of[s] = static_cast<uint8_t>(literal_code_.length(s));
  for (uint32_t s = 0; s < distances; ++s) length_of[literals + s] = static_cast<uint8_t>(distance_code_.length(s));
  header_size_ = 0;
  put_header({last ? 1U : 0U, 1});
  put_header({2, 2});
  put_header({literals - 257, 5});
  put_header({distances - 1, 5});
  put_lengths({length_of, lengths});
}

void Deflater::put_lengths(Span<const uint8_t> length_of) {
  uint32_t count[length_symbols] = {};
  visit_lengths(length_of, [&](uint32_t symbol, uint32_t, uint32_t) { ++count[symbol]; });
  PrefixCode code;
  code.make({count, length_symbols}, longest_length_word);
  uint32_t written = length_symbols;
  while (written > 4 && code.length(length_order[written - 1]) == 0) --written;
  put_header({written - 4, 4});
  for (uint32_t k = 0; k < written; ++k) put_header({code.length(length_order[k]), 3});
  visit_lengths(length_of, [&](uint32_t symbol, uint32_t rest, uint32_t bits) {
    put_header({code.word(symbol) | rest << code.length(symbol), code.length(symbol) + bits});
  });
}

}  // namespace hsp
