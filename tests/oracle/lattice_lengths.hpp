// From lattice balls to lengths, as the interface takes them, and back.
#pragma once

#include <array>

#include "ball_list.hpp"
#include "lattice_ball.hpp"

namespace oracle {

// Every number times the step.
support::BallList in_lengths(const Balls &balls, double step);

// The nearest lattice ball, for lengths in steps: x, y, z, radius.
LatticeBall nearest_ball(const std::array<double, 4> &lengths);

// Centres, and radii plus a probe, as the nearest multiples of a step.
Balls on_lattice(const support::BallList &balls, double probe, double steps_per_unit);

}  // namespace oracle
