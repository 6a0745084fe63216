// Partition of 0 .. n - 1 into sets that can be joined.
#ifndef HARDSPHERE_TESTS_ORACLE_DISJOINT_SETS_HPP
#define HARDSPHERE_TESTS_ORACLE_DISJOINT_SETS_HPP

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace oracle {

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }

  [[nodiscard]] std::size_t find(std::size_t element) const {
    while (parent_[element] != element) element = parent_[element];
    return element;
  }

  /// The smallest element of a set stays its name.
  void join(std::size_t a, std::size_t b) {
    a = find(a);
    b = find(b);
    parent_[a < b ? b : a] = a < b ? a : b;
  }

  /// numbers()[element] = 0, 1, 2, ... by set, in the order of the sets' smallest elements.
  [[nodiscard]] std::vector<std::uint32_t> numbers() const {
    std::vector<std::uint32_t> number(parent_.size());
    std::uint32_t sets = 0;
    for (std::size_t k = 0; k < parent_.size(); ++k) number[k] = find(k) == k ? sets++ : number[find(k)];
    return number;
  }

  [[nodiscard]] std::uint32_t count() const {
    std::uint32_t sets = 0;
    for (std::size_t k = 0; k < parent_.size(); ++k) sets += find(k) == k ? 1U : 0U;
    return sets;
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace oracle

#endif
