// Disjoint sets over caller memory with path halving. The caller's order decides which of two roots survives, so that
// the representative of a set can be made canonical.
#pragma once

#include "core/span.hpp"

namespace hsp {

class DisjointSets {
 public:
  DisjointSets() = default;
  explicit DisjointSets(Span<uint32_t> parent) : parent_(parent) {}

  uint32_t size() const { return parent_.size(); }
  void reset() {
    for (uint32_t k = 0; k < parent_.size(); ++k) parent_[k] = k;
  }
  uint32_t find(uint32_t k) {
    while (parent_[k] != k) {
      parent_[k] = parent_[parent_[k]];
      k = parent_[k];
    }
    return k;
  }
  // Whether the root is k's parent: then they are in one set.
  bool has_parent(uint32_t k, uint32_t root) const { return parent_[k] == root; }
  // The root without path halving, for shared reading.
  uint32_t root(uint32_t k) const {
    while (parent_[k] != k) k = parent_[k];
    return k;
  }
  // Joins two sets; the root for which before(root, other_root) holds stays root. Returns false if they were one set
  // already.
  template <class Before>
  bool join(uint32_t a, uint32_t b, Before before) {
    a = find(a);
    b = find(b);
    if (a == b) return false;
    if (before(a, b)) {
      parent_[b] = a;
    } else {
      parent_[a] = b;
    }
    return true;
  }
  bool join(uint32_t a, uint32_t b) {
    return join(a, b, [](uint32_t x, uint32_t y) { return x < y; });
  }

 private:
  Span<uint32_t> parent_;
};

}  // namespace hsp
