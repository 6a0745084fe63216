// Cubes whose hashes are the same: the linear form that the hash begins with is 0 for all of them.
#pragma once

#include "model/cube_slots.hpp"
#include "random_balls.hpp"

inline hsp::CubeCoordinates colliding_cube(int64_t k) {
  const auto [x, y, z] = oracle::colliding_steps[0];
  return {k * x, k * y, k * z};
}
