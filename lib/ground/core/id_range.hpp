// Consecutive ids, for range-based loops.
#pragma once

#include <cstdint>

namespace hsp {

struct IdRange {
  uint32_t first = 0, last = 0;  // last is one past the end

  class Iterator {
   public:
    constexpr explicit Iterator(uint32_t id) : id_(id) {}
    constexpr uint32_t operator*() const { return id_; }
    constexpr Iterator &operator++() {
      ++id_;
      return *this;
    }
    constexpr bool operator!=(const Iterator &other) const { return id_ != other.id_; }

   private:
    uint32_t id_;
  };

  constexpr Iterator begin() const { return Iterator(first); }
  constexpr Iterator end() const { return Iterator(last); }
  constexpr uint32_t size() const { return last - first; }
  constexpr bool empty() const { return last == first; }
  constexpr bool contains(uint32_t id) const { return id >= first && id < last; }
};

}  // namespace hsp
