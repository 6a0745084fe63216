#include "model/ball_set.hpp"

namespace hsp {

Status BallRounding::prepare(const BallInput &input, uint32_t &first_bad) {
  input_ = input;
  first_bad = no_id;
  if (!is_finite(input.probe) || !is_finite(input.step) || !is_finite(input.largest_radius)) return Status::not_finite;
  if (input.probe < 0.0 || input.step < 0.0 || input.largest_radius < 0.0) return Status::negative;

  double largest = 0.0;
  uint32_t largest_ball = no_id;
  for (uint32_t i = 0; i < input.n; ++i) {
    const double radius = input.radius[i];
    if (!is_finite(radius) || radius < 0.0) {
      first_bad = i;
      return is_finite(radius) ? Status::negative : Status::not_finite;
    }
    if (input.largest_radius > 0.0 && radius > input.largest_radius) {
      first_bad = i;
      return Status::range;
    }
    if (radius > largest) {
      largest = radius;
      largest_ball = i;
    }
  }
  if (input.largest_radius > 0.0) {
    largest = input.largest_radius;
    largest_ball = no_id;
  }
  if (input.step != 0.0) {
    lattice_ = exact::Lattice::with_step(input.step);
    if (!is_finite(lattice_.steps(1.0))) return Status::range;
  } else if (!exact::Lattice::for_largest_radius(largest, input.probe, lattice_)) {
    // The ball is reported only if it is too large even without the probe.
    if (!exact::Lattice::for_largest_radius(largest, 0.0, lattice_)) first_bad = largest_ball;
    return Status::range;
  }
  const double probe = lattice_.steps(input.probe);
  if (!(probe < exact::radius_limit)) return Status::range;
  probe_steps_ = nearest(probe);
  const double expected = lattice_.steps(input.largest_radius);
  if (!(expected + probe < exact::radius_limit)) return Status::range;
  expected_radius_ = input.largest_radius > 0.0 ? nearest(expected) + probe_steps_ : 0;
  return Status::ok;
}

Status BallRounding::round(uint32_t i, exact::LatticeBall &ball) const {
  double steps[3];
  for (uint32_t axis = 0; axis < 3; ++axis) {
    const double coordinate = input_.xyz[3 * static_cast<size_t>(i) + axis];
    if (!is_finite(coordinate)) return Status::not_finite;
    steps[axis] = lattice_.steps(coordinate);
    if (!(steps[axis] <= exact::coordinate_limit && steps[axis] >= -exact::coordinate_limit)) return Status::range;
  }
  const double radius = lattice_.steps(input_.radius[i]);
  if (!(radius < exact::radius_limit)) return Status::range;
  ball.centre = {nearest(steps[0]), nearest(steps[1]), nearest(steps[2])};
  ball.radius = nearest(radius) + probe_steps_;
  ball.index = i;
  return static_cast<double>(ball.radius) < exact::radius_limit ? Status::ok : Status::range;
}

}  // namespace hsp
