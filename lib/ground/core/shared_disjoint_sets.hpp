// Disjoint sets that several threads may join at once, over caller memory. For every order of joins, the smallest
// number represents a set and no number has a larger parent, as in DisjointSets, which reads the sets when all joins
// are done.
//
// Once a number has a parent other than itself, this stays so. Only a number that is its own parent is given another
// one, by compare and exchange. So nothing is lost: a thread that comes too late looks for the representative again.
// Halving a path may store a parent that is no longer the smallest ancestor, but it is an ancestor.
#pragma once

#include "core/span.hpp"

namespace hsp {

class SharedDisjointSets {
 public:
  // Without lock-free operations they would be calls of a run-time library.
#if defined(__GCC_ATOMIC_INT_LOCK_FREE) && __GCC_ATOMIC_INT_LOCK_FREE == 2
  static constexpr bool available = true;
#else
  static constexpr bool available = false;
#endif

  explicit SharedDisjointSets(Span<uint32_t> parent) : parent_(parent) {}

  void join(uint32_t a, uint32_t b) {
    if constexpr (available) {
      if (parent_of(a) == parent_of(b)) return;  // mostly so if there are many joins
      for (;;) {
        a = find(a);
        b = find(b);
        if (a == b) return;
        const uint32_t smaller = a < b ? a : b;
        uint32_t larger = a < b ? b : a;
        if (__atomic_compare_exchange_n(&parent_[larger], &larger, smaller, false, __ATOMIC_RELAXED, __ATOMIC_RELAXED))
          return;
      }
    }
  }

 private:
  uint32_t parent_of(uint32_t k) const {
    return __atomic_load_n(&parent_[k], __ATOMIC_RELAXED);
  }
  uint32_t find(uint32_t k) {
    for (uint32_t parent; (parent = parent_of(k)) != k;) {
      const uint32_t grandparent = parent_of(parent);
      if (grandparent != parent) __atomic_store_n(&parent_[k], grandparent, __ATOMIC_RELAXED);
      k = grandparent;
    }
    return k;
  }

  Span<uint32_t> parent_;
};

}  // namespace hsp
