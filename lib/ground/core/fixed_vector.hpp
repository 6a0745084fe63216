// A vector over memory of fixed capacity. It keeps counting when it is full, so that an overflow reports the number
// that would have sufficed.
//
// As an example room for two records: after push(a), push(b) and push(c) it holds a and b, overflowed() is true, and
// required() is 3, which is the limit to try again with.
#pragma once

#include "core/span.hpp"
#include "core/status.hpp"

namespace hsp {

// A number of records as a limit; no_id if the number is too large for a limit.
constexpr uint32_t clamped_count(uint64_t count) {
  return count < no_id ? static_cast<uint32_t>(count) : no_id;
}

template <class T>
class FixedVector {
 public:
  constexpr FixedVector() = default;
  constexpr explicit FixedVector(Span<T> storage) : storage_(storage) {}

  constexpr void clear() { required_ = 0; }
  // Keeps the first `count` records of a vector that has not overflowed.
  constexpr void shrink(uint32_t count) {
    check_index(count <= required_);
    required_ = count;
  }
  constexpr void push(const T &value) {
    if (required_ < storage_.size()) storage_[static_cast<uint32_t>(required_)] = value;
    ++required_;
  }
  // The same as if `count` records had been pushed; the caller writes them into their slots.
  constexpr void set_count(uint64_t count) { required_ = count; }
  // Records pushed since clear(), stored or not.
  constexpr uint64_t required() const { return required_; }
  constexpr bool overflowed() const { return required_ > storage_.size(); }
  constexpr uint32_t capacity() const { return storage_.size(); }
  // All slots, whether or not they hold records.
  constexpr Span<T> room() { return storage_; }
  // The stored records.
  constexpr uint32_t size() const { return overflowed() ? storage_.size() : static_cast<uint32_t>(required_); }
  constexpr const T &operator[](uint32_t k) const {
    check_index(k < required_);
    return storage_[k];
  }
  constexpr T &operator[](uint32_t k) {
    check_index(k < required_);
    return storage_[k];
  }
  constexpr Span<const T> items() const { return storage_.part(0, size()); }
  constexpr Span<T> items() { return storage_.part(0, size()); }

 private:
  Span<T> storage_;
  uint64_t required_ = 0;
};

}  // namespace hsp
