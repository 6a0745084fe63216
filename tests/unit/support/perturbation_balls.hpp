// Sets of four balls in which ties abound: spheres through one point, centres in a plane or on a line, spheres through
// one circle, tangencies from outside and inside, equal balls, radius 0, pieces of lattices; small, or as large as the
// contract allows, or next to a tie by one step.
#pragma once

#include "perturbation_determinants.hpp"
#include "random_balls.hpp"

namespace perturbation {

enum class Size {
  small,      // 2 r and distances of balls that meet at most 2^9
  near_limit  // radii up to 2^30 - 1, coordinates up to 2^50
};

struct TiedBalls {
  Ball ball[4];
};

TiedBalls random_tied_balls(oracle::RandomSource &random, Size size);

}  // namespace perturbation
