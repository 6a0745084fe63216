#include "pair_formulas.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace {

using Real = long double;

constexpr Real pi = std::numbers::pi_v<Real>;

Real sphere_area(Real r) {
  return 4 * pi * r * r;
}
Real ball_volume(Real r) {
  return 4 * pi / 3 * r * r * r;
}
// Of a ball, beyond a plane that is h from its centre.
Real cap_volume(Real r, Real h) {
  return pi * (r - h) * (r - h) * (2 * r + h) / 3;
}

}  // namespace

std::array<Real, 2> PairFormulas::areas(Real d) const {
  if (d >= sum()) return {sphere_area(r_[0]), sphere_area(r_[1])};
  if (d <= difference()) {
    if (r_[0] >= r_[1]) return {sphere_area(r_[0]), 0};
    return {0, sphere_area(r_[1])};
  }
  return {2 * pi * r_[0] * (r_[0] + height(0, d)), 2 * pi * r_[1] * (r_[1] + height(1, d))};
}

Real PairFormulas::volume(Real d) const {
  if (d <= difference()) return ball_volume(std::max(r_[0], r_[1]));
  Real sum_of_balls = ball_volume(r_[0]) + ball_volume(r_[1]);
  if (d >= sum()) return sum_of_balls;
  for (const size_t i : {0U, 1U}) sum_of_balls -= cap_volume(r_[i], height(i, d));
  return sum_of_balls;
}

std::array<Real, 2> PairFormulas::areas_by_distance(Real d) const {
  return {pi * r_[0] * (1 - excess(0) / (d * d)), pi * r_[1] * (1 - excess(1) / (d * d))};
}

Real PairFormulas::volume_by_distance(Real d) const {
  const Real h = height(0, d);
  return pi * (r_[0] - h) * (r_[0] + h);
}

std::array<Real, 2> PairFormulas::fifth_derivatives_of_areas(Real least) const {
  const Real common = 120 * pi * std::abs(excess(0)) / std::pow(least, 6);
  return {r_[0] * common, r_[1] * common};
}

Real PairFormulas::fifth_derivative_of_total(Real least) const {
  return 120 * pi * sum() * difference() * difference() / std::pow(least, 6);
}

Real PairFormulas::fifth_derivative_of_volume(Real least) const {
  return 120 * pi * excess(0) * excess(0) / 4 / std::pow(least, 6);
}
