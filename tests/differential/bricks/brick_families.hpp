// Random and degenerate sets in twelve families, for what is cut into bricks.
#pragma once

#include <string>

#include "lattice_ball.hpp"
#include "random_numbers.hpp"

struct BrickSet {
  oracle::Balls balls;
  std::string family;
};

// Three of ten lie 2^40 steps away from the origin.
BrickSet random_brick_set(support::Random &random);
