// A directory of the non-empty cubes in lexicographic order, with binary search: Theorem 3.1, with a sorted array in
// place of a balanced tree. The cubes of a row follow each other, so that a row needs one search.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "section_3/cubes.hpp"
#include "section_3/grouped_balls.hpp"

namespace bench {

class SortedCubes {
 public:
  void build(const Cubes &, const std::vector<Cube> &cube, std::vector<uint32_t> &numbers) {
    balls_.clear();
    for (const Cube &c : cube) balls_.push_back({packed(c), static_cast<uint32_t>(balls_.size())});
    std::sort(balls_.begin(), balls_.end(), [](const Entry &a, const Entry &b) { return a.key < b.key; });
    keys_.clear();
    numbers.resize(cube.size());
    for (const Entry &entry : balls_) {
      if (keys_.empty() || keys_.back() != entry.key) keys_.push_back(entry.key);
      numbers[entry.ball] = static_cast<uint32_t>(keys_.size() - 1);
    }
  }

  uint32_t count() const { return static_cast<uint32_t>(keys_.size()); }

  template <class Visit>
  void visit_row(uint32_t x_low, uint32_t x_high, uint32_t y, uint32_t z, Visit visit) const {
    const auto first = std::lower_bound(keys_.begin(), keys_.end(), packed({x_low, y, z}));
    const uint64_t highest = packed({x_high, y, z});
    auto last = first;
    while (last != keys_.end() && *last <= highest) ++last;
    if (first != last) visit(static_cast<uint32_t>(first - keys_.begin()), static_cast<uint32_t>(last - keys_.begin()));
  }

  size_t bytes() const { return bytes_of(keys_); }

 private:
  struct Entry {
    uint64_t key;
    uint32_t ball;
  };
  std::vector<uint64_t> keys_;  // ascending
  std::vector<Entry> balls_;    // while building
};

}  // namespace bench
