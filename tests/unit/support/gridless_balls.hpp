// Balls in arrays of their own, for parts of the library that need no grid.
#pragma once

#include <cstdint>

#include "model/ball_set.hpp"

template <uint32_t most>
class GridlessBalls {
 public:
  GridlessBalls() {
    // Behind the words of lanes.
    set_.x = {numbers_ + 2 * most, most};
    set_.y = {numbers_ + 3 * most, most};
    set_.z = {numbers_ + 4 * most, most};
    set_.r = {numbers_ + 5 * most, most};
    set_.caller = {caller_, most};
  }
  GridlessBalls(const GridlessBalls &) = delete;
  GridlessBalls &operator=(const GridlessBalls &) = delete;

  void clear() { set_.n = 0; }
  void add(const hsp::exact::LatticeBall &ball) { set_.store(set_.n++, ball); }
  // Adds a ball whose index is the number of balls before it.
  void add(int64_t x, int64_t y, int64_t z, int64_t radius) { add({{x, y, z}, radius, set_.n}); }

  const hsp::BallSet &set() const { return set_; }

 private:
  double numbers_[6 * most];
  uint32_t caller_[most];
  hsp::BallSet set_;
};
