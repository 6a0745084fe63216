// Horizontal slices through a union of balls: between which heights the picture in a slice keeps its structure, and
// which arcs of the circles in a slice are free.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "lattice_ball.hpp"

namespace oracle {

struct RealBall {
  long double x = 0;
  long double y = 0;
  long double z = 0;
  long double radius = 0;
};

std::vector<RealBall> real_balls(const Balls &balls);

// The balls moved so that the mean of their centres is the origin: terms that cancel stay as small as the set.
std::vector<RealBall> around_their_middle(const std::vector<RealBall> &balls);

// Heights between two neighbouring changes (ends of balls, ends of intersection circles, points of three spheres),
// with the balls that reach into them. In between, free angles are smooth functions of the height, with roots at the
// ends.
struct Slab {
  long double low = 0;
  long double high = 0;
  std::vector<size_t> active;
};

// From bottom to top; slabs without a ball and slabs as thin as rounding are left out.
std::vector<Slab> slabs_of(const std::vector<RealBall> &balls);

// A free arc of the circle that a ball's sphere makes in a slice, counter-clockwise from an angle to a larger one.
struct FreeSliceArc {
  // The ball whose disc covers the circle up to the start of the arc. No two arcs of one circle have the same ball; a
  // whole circle has none.
  static constexpr size_t none = std::numeric_limits<size_t>::max();

  size_t after = none;
  long double from = 0;
  long double to = 0;
};

struct SliceCircle {
  size_t ball = 0;
  long double radius = 0;
  std::vector<FreeSliceArc> arcs;
};

// The circles of a slice that are not covered wholly. Of equal circles the first is taken to be outside the others.
std::vector<SliceCircle> circles_of_slice(const std::vector<RealBall> &balls, const std::vector<size_t> &active,
                                          long double z);

// Tanh-sinh quadrature, which takes roots at the ends in its stride: visit(z, weight) for
// z = middle + half tanh(pi/2 sinh t), t = 0, +-step, ...; beyond |t| = 3.4 the weights are below 1e-19.
template <class Visit>
void visit_tanh_sinh_nodes(long double low, long double high, long double step, const Visit &visit) {
  const long double half = (high - low) / 2;
  constexpr long double quarter_turn = std::numbers::pi_v<long double> / 2;
  const int nodes = static_cast<int>(std::floor(3.4L / step));
  for (int node = -nodes; node <= nodes; ++node) {
    const long double t = step * static_cast<long double>(node);
    const long double s = quarter_turn * std::sinh(t);
    const long double to_end = half * 2 / (1 + std::exp(2 * std::abs(s)));  // distance from the nearer end
    visit(node < 0 ? low + to_end : high - to_end,
          half * step * quarter_turn * std::cosh(t) / (std::cosh(s) * std::cosh(s)));
  }
}

}  // namespace oracle
