// A directory that has a number for every cube of the surrounding box, empty or not: no search at all, but memory grows
// with the box and not with the balls.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "section_3/cubes.hpp"

namespace bench {

class DenseCubes {
 public:
  static constexpr double most_cubes = 1 << 28;

  // Throws std::length_error beyond most_cubes.
  void build(const Cubes &cubes, const std::vector<Cube> &cube, std::vector<uint32_t> &numbers) {
    const double all = double{1} * cubes.along(0) * cubes.along(1) * cubes.along(2);
    if (all > most_cubes) throw std::length_error("too many cubes for a dense grid");
    along_x_ = cubes.along(0);
    along_y_ = cubes.along(1);
    count_ = static_cast<uint32_t>(all);
    numbers.clear();
    for (const Cube &c : cube) numbers.push_back(number(c.x, c.y, c.z));
  }

  uint32_t count() const { return count_; }

  template <class Visit>
  void visit_row(uint32_t x_low, uint32_t x_high, uint32_t y, uint32_t z, Visit visit) const {
    const uint32_t row = number(0, y, z);
    visit(row + x_low, row + x_high + 1);
  }

  size_t bytes() const { return 0; }

 private:
  uint32_t number(uint32_t x, uint32_t y, uint32_t z) const { return (z * along_y_ + y) * along_x_ + x; }

  uint32_t along_x_ = 0, along_y_ = 0, count_ = 0;
};

}  // namespace bench
