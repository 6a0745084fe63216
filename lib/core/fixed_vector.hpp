// A vector over memory of fixed capacity that goes on counting when it is full, so that an overflow ends with the
// number that would have sufficed instead of a guess.
#pragma once

#include "core/span.hpp"

namespace hsp {

template <class T>
class FixedVector {
 public:
  constexpr FixedVector() = default;
  constexpr explicit FixedVector(Span<T> storage) : storage_(storage) {}

  constexpr void clear() { wanted_ = 0; }
  constexpr void push(const T &value) {
    if (wanted_ < storage_.size()) storage_[static_cast<uint32_t>(wanted_)] = value;
    ++wanted_;
  }
  // Records pushed since clear(), stored or not.
  constexpr uint64_t wanted() const { return wanted_; }
  constexpr bool overflowed() const { return wanted_ > storage_.size(); }
  constexpr uint32_t capacity() const { return storage_.size(); }
  // The stored records.
  constexpr uint32_t size() const { return overflowed() ? storage_.size() : static_cast<uint32_t>(wanted_); }
  constexpr T &operator[](uint32_t k) const { return storage_[k]; }
  constexpr Span<T> items() const { return storage_.part(0, size()); }

 private:
  Span<T> storage_;
  uint64_t wanted_ = 0;
};

}  // namespace hsp
