// Four balls seen from the first of them, for tests of predicates: sizes up to the limits of the contract, and many
// ties.
#pragma once

#include "exact/lattice_ball.hpp"
#include "random_balls.hpp"

struct FourBalls {
  hsp::exact::LatticeBall ball[4];
  hsp::exact::Sphere sphere;
  hsp::exact::Plane plane[3];
};

// All three others meet the first in a circle.
FourBalls random_four_balls(oracle::RandomSource &random);
