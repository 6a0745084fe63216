// Cubes of the grid whose hashes are all the same: the linear form that the library's hash begins with is 0 for each.
#pragma once

#include "model/cube_slots.hpp"
#include "random_balls.hpp"

inline hsp::CubeCoordinates colliding_cube(int64_t k) {
  const auto [x, y, z] = oracle::colliding_steps[0];
  return {k * x, k * y, k * z};
}
