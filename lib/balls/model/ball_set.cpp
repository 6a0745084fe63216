#include "model/ball_set.hpp"

#include <limits>

#include "lanes/wide.hpp"

namespace hsp {
namespace {

// The status of a ball that does not fit the lattice. The first coordinate that does not fit decides; the radius is
// finite.
Status why_off_lattice(const exact::Lattice &lattice, const double *xyz) {
  for (uint32_t axis = 0; axis < 3; ++axis) {
    if (!is_finite(xyz[axis])) return Status::not_finite;
    if (!(std::fabs(lattice.steps(xyz[axis])) <= exact::coordinate_limit)) return Status::range;
  }
  return Status::range;
}

}  // namespace

Status round_ball(const exact::Lattice &lattice, int64_t probe_steps, const double *xyz, double radius, uint32_t i,
                  exact::LatticeBall &ball) {
  const double steps = lattice.steps(radius);
  if (!lattice.round(xyz, ball.centre) || !(steps < exact::radius_limit)) return why_off_lattice(lattice, xyz);
  ball.radius = nearest(steps) + probe_steps;
  ball.index = i;
  return static_cast<double>(ball.radius) < exact::radius_limit ? Status::ok : Status::range;
}

Status BallRounding::prepare(const BallInput &input, uint32_t &first_bad) {
  input_ = input;
  first_bad = no_id;
  const double options[] = {input.probe, input.step, input.largest_radius};
  for (const double option : options) {
    if (!is_finite(option)) return Status::not_finite;
  }
  for (const double option : options) {
    if (option < 0.0) return Status::negative;
  }

  // First the lattice, unless it depends on the balls.
  const bool expected = input.largest_radius != 0.0;
  if (input.step != 0.0) {
    lattice_ = exact::Lattice::with_step(input.step);
    if (!is_finite(lattice_.steps(1.0))) return Status::range;
  } else if (expected && !exact::Lattice::for_largest_radius(input.largest_radius, input.probe, lattice_)) {
    return Status::range;
  }
  const double most = expected ? input.largest_radius : std::numeric_limits<double>::max();
  double largest = 0.0, smallest = std::numeric_limits<double>::infinity();
  for (uint32_t i = 0; i < input.n; ++i) {
    const double radius = input.radius[i];
    const bool fits = 0.0 <= radius && radius <= most;
    if (!fits && (!expected || !is_expected(radius))) {
      first_bad = i;
      if (!is_finite(radius)) return Status::not_finite;
      return radius < 0.0 ? Status::negative : Status::range;
    }
    largest = largest < radius ? radius : largest;
    smallest = radius < smallest && radius + input.probe > 0.0 ? radius : smallest;
  }
  largest_ = largest;
  smallest_ = is_finite(smallest) ? smallest : -1.0;
  if (input.step == 0.0 && !expected) {
    const bool are_points = largest == 0.0 && input.probe == 0.0;
    if (are_points && !exact::Lattice::for_points(largest_coordinate(), lattice_)) return Status::range;
    if (!are_points && !exact::Lattice::for_largest_radius(largest, input.probe, lattice_)) {
      // The largest ball is reported only if it is too large even without the probe.
      if (!(lattice_.steps(largest) + 0.5 < exact::radius_limit)) {
        for (first_bad = 0; input.radius[first_bad] < largest;) ++first_bad;
      }
      return Status::range;
    }
  }
  const double probe = lattice_.steps(input.probe);
  const double radius = lattice_.steps(input.largest_radius);
  if (!(radius + probe < exact::radius_limit)) return Status::range;
  probe_steps_ = nearest(probe);
  expected_radius_ = nearest(radius) + probe_steps_;
  // If the step is too small for every radius, the step is at fault and no ball is reported.
  if (input.step != 0.0 && !radius_fits(largest_)) {
    uint32_t refused = 0;
    while (refused < input.n && !radius_fits(input.radius[refused])) ++refused;
    if (refused == input.n) return Status::range;
  }
  return Status::ok;
}

// The largest radius may come from a report that was rounded to the lattice. So both are compared on the lattice.
bool BallRounding::is_expected(double radius) const {
  const double most = lattice_.steps(input_.largest_radius);
  return radius >= 0.0 && most < exact::radius_limit && lattice_.steps(radius) < exact::radius_limit &&
         nearest(lattice_.steps(radius)) <= nearest(most);
}

// Leaves out what is not finite; find_box() reports that.
double BallRounding::largest_coordinate() const {
  double largest = input_.extent;
  for (uint64_t k = 0; k < 3 * uint64_t{input_.n}; ++k) {
    const double size = std::fabs(input_.xyz[k]);
    if (is_finite(size) && size > largest) largest = size;
  }
  return largest;
}

bool BallRounding::radius_fits(double radius) const {
  const double steps = lattice_.steps(radius);
  return steps < exact::radius_limit && static_cast<double>(rounded_radius(radius)) < exact::radius_limit;
}

Status BallRounding::find_box(LatticeBox &box, uint32_t &first_bad) const {
  // Rounding keeps the order of numbers, so the least and the largest coordinate tell whether all are on the lattice.
  // Comparisons may lose a NaN, but the sum keeps it. The sum is NaN if a coordinate is; else only if coordinates are
  // infinite, which the least or the largest one tells, too.
  constexpr double infinity = std::numeric_limits<double>::infinity();
  // Two balls at a time are three registers: x y, z x, y z.
  using L = Wide<double, 2>;
  L::Real least[3], most[3], sum[3];
  for (int k = 0; k < 3; ++k) {
    least[k] = L::all(infinity);
    most[k] = L::all(-infinity);
    sum[k] = L::all(0.0);
  }
  const auto add = [&](int k, const L::Real &value) {
    least[k] = L::smaller(least[k], value);
    most[k] = L::larger(most[k], value);
    sum[k] += value;
  };
  const double *xyz = input_.xyz;
  for (uint32_t pairs = input_.n / 2; pairs > 0; --pairs, xyz += 6) {
    for (int k = 0; k < 3; ++k) add(k, L::load(xyz + 2 * k));
  }
  if (input_.n % 2 != 0) {
    add(0, L::load(xyz));
    add(1, L::Real{xyz[2], xyz[0]});
  }
  double low[3], high[3];
  bool comparable = true;
  for (int axis = 0; axis < 3; ++axis) {
    // The register and lane of this axis for the first ball of a pair, and for the second.
    const int k = axis / 2, first = axis % 2, l = (axis + 3) / 2, second = (axis + 3) % 2;
    low[axis] = least[k][first] < least[l][second] ? least[k][first] : least[l][second];
    high[axis] = most[k][first] > most[l][second] ? most[k][first] : most[l][second];
    const double both = sum[k][first] + sum[l][second];
    comparable = comparable && both == both;
  }
  exact::LatticeBall largest;
  if (comparable && lattice_.round(low, box.low) && lattice_.round(high, box.high) &&
      round_ball(lattice_, probe_steps_, low, largest_, 0, largest) == Status::ok) {
    return Status::ok;
  }
  for (uint32_t i = 0; i < input_.n; ++i) {
    first_bad = i;
    if (const Status status = round(i, largest); status != Status::ok) return status;
  }
  return Status::range;
}

}  // namespace hsp
