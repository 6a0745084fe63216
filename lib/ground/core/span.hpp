// A pointer with a length. std::span is not used because its checked operator[] imports a run-time function in builds
// with _GLIBCXX_ASSERTIONS, and the archive promises to import none.
//
// With HSP_CHECK_INDEX, which tests and fuzz harnesses define and the archive does not, an index out of range traps.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace hsp {

constexpr void check_index([[maybe_unused]] bool in_range) {
#if HSP_CHECK_INDEX
  if (!in_range) __builtin_trap();
#endif
}

template <class T>
class Span {
 public:
  constexpr Span() = default;
  constexpr Span(T *data, uint32_t size) : data_(data), size_(size) {}
  // A span for readers.
  constexpr operator Span<const T>() const requires(!std::is_const_v<T>) { return {data_, size_}; }

  constexpr T &operator[](uint32_t k) const {
    check_index(k < size_);
    return data_[k];
  }
  constexpr uint32_t size() const { return size_; }
  constexpr bool empty() const { return size_ == 0; }
  constexpr T *data() const { return data_; }
  constexpr T *begin() const { return data_; }
  constexpr T *end() const { return data_ + size_; }
  constexpr Span part(uint32_t first, uint32_t last) const {
    check_index(first <= last && last <= size_);
    return {data_ + first, last - first};
  }

 private:
  T *data_ = nullptr;
  uint32_t size_ = 0;
};

}  // namespace hsp
