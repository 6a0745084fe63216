// Bytes compressed as a zlib stream (RFC 1950) of Deflate blocks (RFC 1951), in memory of fixed size. Earlier bytes are
// repeated by reference, found by hashes of three bytes in chains of limited length; each block has codes of its own.
// The stream depends on the bytes alone, not on the portions in which they come.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/workspace.hpp"
#include "picture/prefix_code.hpp"

namespace hsp {

class Deflater {
 public:
  void carve(Workspace &workspace);

  // Takes bytes. Calls emit(bytes, count) with compressed bytes, at most 1024 at a time.
  template <class Emit>
  void take(const char *bytes, size_t count, const Emit &emit) {
    while (count > 0) {
      const size_t taken = receive(bytes, count);
      bytes += taken;
      count -= taken;
      refer(most_repeated + good_length, emit);
    }
  }
  // Ends the stream.
  template <class Emit>
  void finish(const Emit &emit) {
    refer(0, emit);
    put_block(true, emit);
    if (used_bits_ % 8 != 0) put_bits({0, 8 - used_bits_ % 8}, emit);
    for (int shift = 24; shift >= 0; shift -= 8) put_bits({checksum() >> shift & 255U, 8}, emit);
    emit_full_bytes(emit);
    emit(out_.data(), out_size_);
    out_size_ = 0;
  }

 private:
  static constexpr uint32_t window_bits = 13;
  static constexpr uint32_t window = 1U << window_bits;  // how far back a reference reaches
  static constexpr uint32_t ring = 2 * window;
  static constexpr uint32_t hash_bits = 12;
  static constexpr uint32_t block = 4096;  // references and bytes in a block, at most
  static constexpr uint32_t least_repeated = 3, most_repeated = 258;
  static constexpr uint32_t good_length = 64;  // behind a repeat so long no longer one is looked for a byte later
  static constexpr uint32_t out_bytes = 1024;
  static constexpr uint32_t literals = 286, distances = 30, end_of_block = 256;
  static constexpr uint32_t lengths = literals + distances;

  // A repeat of `length` bytes that stand `distance` bytes before; none if the length is below least_repeated.
  struct Repeat {
    uint32_t length, distance;
  };
  // `count` bits, the lowest first; 24 at most.
  struct Bits {
    uint32_t value, count;
  };
  // A byte, or a repeat: its length times 2^16 and its distance.
  using Item = uint32_t;

  // Makes references until at most `ahead` of the bytes received are left.
  template <class Emit>
  void refer(uint32_t ahead, const Emit &emit) {
    while (received_ - done_ > ahead) {
      advance();
      if (items_ + most_repeated >= block) put_block(false, emit);
    }
  }
  template <class Emit>
  void put_block(bool last, const Emit &emit) {
    make_codes(last);
    for (uint32_t k = 0; k < header_size_; ++k) put_bits({header_[k] >> 8, header_[k] & 255U}, emit);
    for (uint32_t k = 0; k < items_; ++k) {
      const Item item = item_[k];
      if (item < 256) {
        put_word(literal_code_, item, emit);
        continue;
      }
      const Placed length = placed_length(item >> 16), distance = placed_distance(item & 0xFFFFU);
      put_word(literal_code_, length.symbol, emit);
      put_bits(length.rest, emit);
      put_word(distance_code_, distance.symbol, emit);
      put_bits(distance.rest, emit);
    }
    put_word(literal_code_, end_of_block, emit);
    items_ = 0;
  }
  template <class Emit>
  void put_word(const PrefixCode &code, uint32_t symbol, const Emit &emit) {
    put_bits({code.word(symbol), code.length(symbol)}, emit);
  }
  template <class Emit>
  void put_bits(Bits bits, const Emit &emit) {
    pending_ |= static_cast<uint64_t>(bits.value) << used_bits_;
    used_bits_ += bits.count;
    if (used_bits_ >= 32) emit_full_bytes(emit);
  }
  template <class Emit>
  void emit_full_bytes(const Emit &emit) {
    for (; used_bits_ >= 8; used_bits_ -= 8, pending_ >>= 8) {
      out_[out_size_++] = static_cast<char>(pending_ & 255U);
      if (out_size_ < out_bytes) continue;
      emit(out_.data(), out_size_);
      out_size_ = 0;
    }
  }

  // A number as a symbol and the bits that follow it.
  struct Placed {
    uint32_t symbol;
    Bits rest;
  };
  static Placed placed_length(uint32_t length);
  static Placed placed_distance(uint32_t distance);

  // Copies bytes into the ring as far as there is room; returns how many.
  size_t receive(const char *bytes, size_t count);
  // Makes one reference, and before it items of single bytes for which a reference is not worth it.
  void advance();
  Repeat longest_repeat(uint32_t at) const;
  void remember(uint32_t at);
  void push(Item item) { item_[items_++] = item; }
  uint32_t byte(uint32_t at) const { return ring_[at % ring]; }
  uint32_t hash(uint32_t at) const;
  uint32_t checksum() const { return high_sum_ << 16 | low_sum_; }

  // Makes the codes of the block's items, and the header bits that describe these codes.
  void make_codes(bool last);
  void put_lengths(Span<const uint8_t> length_of);
  void put_header(Bits bits) { header_[header_size_++] = bits.value << 8 | bits.count; }

  Span<uint8_t> ring_;
  Span<uint16_t> back_;    // [window] distance to the last position before with the same hash; 0: none in reach
  Span<uint32_t> last_;    // [hashes] the last position with this hash
  Span<uint32_t> item_;    // [block]
  Span<char> out_;         // [out_bytes]
  Span<uint32_t> count_;   // [literals + distances]
  Span<uint32_t> header_;  // [lengths + 32] some bits times 2^8, plus how many they are
  PrefixCode literal_code_, distance_code_;
  uint32_t header_size_ = 0;
  uint32_t received_ = 0, done_ = 0;  // bytes; modulo 2^32
  uint32_t items_ = 0;
  uint32_t out_size_ = 0;
  uint64_t pending_ = 0;
  uint32_t used_bits_ = 0;
  uint32_t low_sum_ = 1, high_sum_ = 0;  // of Adler's checksum
};

}  // namespace hsp
