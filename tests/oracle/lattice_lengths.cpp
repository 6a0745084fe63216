#include "lattice_lengths.hpp"

#include <cmath>

namespace oracle {

support::BallList in_lengths(const Balls &balls, double step) {
  support::BallList list;
  const auto length = [&](int64_t steps) { return static_cast<double>(steps) * step; };
  for (const LatticeBall &ball : balls) list.add(length(ball.x), length(ball.y), length(ball.z), length(ball.radius));
  return list;
}

LatticeBall nearest_ball(const std::array<double, 4> &lengths) {
  return {std::llround(lengths[0]), std::llround(lengths[1]), std::llround(lengths[2]), std::llround(lengths[3])};
}

Balls on_lattice(const support::BallList &balls, double probe, double steps_per_unit) {
  Balls result;
  for (size_t i = 0; i < balls.size(); ++i)
    result.push_back(nearest_ball({balls.xyz[3 * i] * steps_per_unit, balls.xyz[3 * i + 1] * steps_per_unit,
                                   balls.xyz[3 * i + 2] * steps_per_unit, (balls.radius[i] + probe) * steps_per_unit}));
  return result;
}

}  // namespace oracle
