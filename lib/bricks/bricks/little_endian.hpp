// Integers as bytes, the lowest first, at any address: the same bytes on every machine.
//
// As an example the number 258 in four bytes: 2 1 0 0.
#pragma once

#include <bit>
#include <cstring>

#include "exact/wide_integer.hpp"

namespace hsp {

template <class Integer>
Integer load_little(const uint8_t *from) {
  Integer value;
  std::memcpy(&value, from, sizeof value);
  if constexpr (std::endian::native == std::endian::big) {
    if constexpr (sizeof value == 8) return static_cast<Integer>(__builtin_bswap64(static_cast<uint64_t>(value)));
    if constexpr (sizeof value == 4) return static_cast<Integer>(__builtin_bswap32(static_cast<uint32_t>(value)));
  }
  return value;
}

template <class Integer>
void store_little(Integer value, uint8_t *to) {
  static_assert(sizeof value == 4 || sizeof value == 8);
  // Storing reverses bytes as loading does.
  const Integer turned = load_little<Integer>(reinterpret_cast<const uint8_t *>(&value));
  std::memcpy(to, &turned, sizeof turned);
}

// A record has one list of fields for both directions: visit(io, record) passes each of its fields to io.
class LittleReader {
 public:
  explicit LittleReader(const uint8_t *from) : at_(from) {}

  template <class Integer>
  void operator()(Integer &value) {
    value = load_little<Integer>(at_);
    at_ += sizeof value;
  }
  template <int bits>
  void operator()(exact::WideInteger<exact::FastLimb, bits> &value) {
    for (exact::FastLimb &limb : value.limb) (*this)(limb);
  }

 private:
  const uint8_t *at_;
};

class LittleWriter {
 public:
  explicit LittleWriter(uint8_t *to) : at_(to) {}

  template <class Integer>
  void operator()(const Integer &value) {
    store_little(value, at_);
    at_ += sizeof value;
  }
  template <int bits>
  void operator()(const exact::WideInteger<exact::FastLimb, bits> &value) {
    for (const exact::FastLimb &limb : value.limb) (*this)(limb);
  }

 private:
  uint8_t *at_;
};

// How many bytes a record takes.
class LittleCounter {
 public:
  template <class Integer>
  constexpr void operator()(const Integer &) {
    bytes_ += sizeof(Integer);
  }
  constexpr uint32_t bytes() const { return bytes_; }

 private:
  uint32_t bytes_ = 0;
};
template <class Record>
constexpr uint32_t little_bytes_of() {
  LittleCounter counter;
  Record record{};
  Record::visit(counter, record);
  return counter.bytes();
}
template <class Record>
inline constexpr uint32_t little_bytes = little_bytes_of<Record>();

template <class Record>
Record load_record(const uint8_t *from) {
  Record record;
  LittleReader reader(from);
  Record::visit(reader, record);
  return record;
}
template <class Record>
void store_record(const Record &record, uint8_t *to) {
  LittleWriter writer(to);
  Record::visit(writer, record);
}

}  // namespace hsp
