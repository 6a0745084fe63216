// Partition of 0 .. n - 1 into sets that can be joined.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace oracle {

class DisjointSets {
 public:
  explicit DisjointSets(size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), size_t{0}); }

  [[nodiscard]] size_t find(size_t element) const {
    while (parent_[element] != element) element = parent_[element];
    return element;
  }

  // The smallest element of a set stays its name.
  void join(size_t a, size_t b) {
    a = find(a);
    b = find(b);
    parent_[a < b ? b : a] = a < b ? a : b;
  }

  // numbers()[element] = 0, 1, 2, ... by set, in the order of the sets' smallest elements.
  [[nodiscard]] std::vector<uint32_t> numbers() const {
    std::vector<uint32_t> number(parent_.size());
    uint32_t sets = 0;
    for (size_t k = 0; k < parent_.size(); ++k) number[k] = find(k) == k ? sets++ : number[find(k)];
    return number;
  }

  [[nodiscard]] uint32_t count() const {
    uint32_t sets = 0;
    for (size_t k = 0; k < parent_.size(); ++k) sets += find(k) == k ? 1U : 0U;
    return sets;
  }

 private:
  std::vector<size_t> parent_;
};

}  // namespace oracle
