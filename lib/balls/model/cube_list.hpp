// The coordinates of cubes, which are numbered in the order in which they come.
#pragma once

#include "core/span.hpp"
#include "model/cube_slots.hpp"

namespace hsp {

class CubeList {
 public:
  // Memory for as many cubes as the array has entries.
  void take(Span<CubeCoordinates> cubes) { cubes_ = cubes; }
  void clear() { count_ = 0; }
  void push(const CubeCoordinates &cube) {
    if (count_ == 0) low_ = high_ = cube;
    widen(cube.x, low_.x, high_.x);
    widen(cube.y, low_.y, high_.y);
    widen(cube.z, low_.z, high_.z);
    cubes_[count_++] = cube;
  }
  uint32_t count() const { return count_; }
  const CubeCoordinates &coordinates(uint32_t number) const { return cubes_[number]; }
  // coordinates() as a function, for CubeSlots.
  auto cube_of() const {
    return [cubes = cubes_](uint32_t number) -> const CubeCoordinates & { return cubes[number]; };
  }
  // The corners of the box around all cubes, if there are any.
  const CubeCoordinates &low() const { return low_; }
  const CubeCoordinates &high() const { return high_; }

  // Widens the interval so that it holds the value.
  static void widen(int64_t value, int64_t &low, int64_t &high) {
    low = value < low ? value : low;
    high = value > high ? value : high;
  }

 private:
  Span<CubeCoordinates> cubes_;
  uint32_t count_ = 0;
  CubeCoordinates low_{}, high_{};
};

}  // namespace hsp
