// Disjoint sets of numbers (union-find) over caller memory, with path halving. The smallest number represents a set,
// and no number has a parent larger than itself.
//
// As an example five numbers:
//   at first      parents 0 1 2 3 4
//   join(3, 4)            0 1 2 3 3
//   join(0, 4)            0 1 2 0 3      the root of 4 is 3, which gets the smaller root 0 as its parent
//   find(4) = 0           0 1 2 0 0      the path of 4 is halved on the way
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
  // Whether `root` is k's parent: then both are in one set.
  bool has_parent(uint32_t k, uint32_t root) const { return parent_[k] == root; }
  // The first index in first .. last - 1 for which the parent of k[index] is not `root`; `last` if there is none.
  uint32_t first_elsewhere(const uint32_t *k, uint32_t first, uint32_t last, uint32_t root) const {
    const uint32_t *const parent = parent_.data();
    while (first < last && parent[k[first]] == root) ++first;
    return first;
  }
  // The root, without path halving: several threads may read at once.
  uint32_t root(uint32_t k) const {
    while (parent_[k] != k) k = parent_[k];
    return k;
  }
  // Joins two sets. Returns false if they were one set already.
  bool join(uint32_t a, uint32_t b) {
    if (parent_[a] == parent_[b]) return false;  // mostly so if there are many joins
    a = find(a);
    b = find(b);
    if (a == b) return false;
    parent_[a < b ? b : a] = a < b ? a : b;
    return true;
  }
  // Afterwards all numbers have their representatives as parents.
  void flatten() {
    for (uint32_t k = 0; k < parent_.size(); ++k) parent_[k] = parent_[parent_[k]];
  }

 private:
  Span<uint32_t> parent_;
};

}  // namespace hsp
