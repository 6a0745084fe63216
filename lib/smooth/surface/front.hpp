// Brings chosen lanes of 32 bits to the front, so that loops over many numbers keep some of them without a branch.
// Everything has internal linkage.
#pragma once

#if defined(__AVX2__)
#include "lanes/words.hpp"
#endif
#include "lanes/wide.hpp"

namespace hsp {
namespace {

// A bit for each of the lowest `count` of n lanes; for all n if count >= n.
template <uint32_t n>
uint32_t first_of(uint32_t count) {
  return (1U << (count < n ? count : n)) - 1U;
}

// Lane k is chosen if bit k is set. Wherever the chosen lanes are written there must be room for all n.
template <uint32_t n>
class Front {
 public:
  explicit Front(uint32_t chosen) {
    uint32_t to = 0;
    for (uint32_t k = 0; k < n; ++k) {
      to_[k] = to;
      to += chosen >> k & 1U;
    }
    count_ = to;
  }
  uint32_t count() const { return count_; }
  void store(float *p, const typename Wide<float, n>::Real &a) const {
    for (uint32_t k = 0; k < n; ++k) p[to_[k]] = a[k];
  }
  void copy(uint32_t *p, const uint32_t *from) const {
    for (uint32_t k = 0; k < n; ++k) p[to_[k]] = from[k];
  }

 private:
  uint32_t to_[n], count_;
};

#if defined(__AVX2__)
template <>
class Front<8> {
 public:
  explicit Front(uint32_t chosen) : order_(FrontOrder::of_eight(chosen)), chosen_(chosen) {}
  uint32_t count() const { return ones(chosen_); }
  void store(float *p, const Wide<float, 8>::Real &a) const { store_front(p, Floats{a}, order_); }
  void copy(uint32_t *p, const uint32_t *from) const { store_front(p, Integers::load(from), order_); }

 private:
  FrontOrder order_;
  uint32_t chosen_;
};
#endif

}  // namespace
}  // namespace hsp
