// Four balls seen from the first of them, for tests of predicates.
#pragma once

#include "exact/lattice_ball.hpp"
#include "random_balls.hpp"

// The three others meet the first, each in a circle.
struct FourBalls {
  hsp::exact::LatticeBall ball[4];

  // Whether the three others meet the first, and all radii are at least `least_radius` and below 2^30.
  bool valid(int64_t least_radius) const;
  hsp::exact::Sphere sphere() const { return hsp::exact::sphere_of(ball[0]); }
  hsp::exact::Plane plane(int k) const { return hsp::exact::plane_of(ball[0], ball[k]); }
  // The squared length of the longest vector in use, for which the filter's bounds are made.
  double length_squared() const;
};

// Sizes up to the limits of the contract, and many ties.
FourBalls random_four_balls(oracle::RandomSource &random);
