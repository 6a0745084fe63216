#include "lane_angles.hpp"

#include "lanes/angle.hpp"
#include "lanes/four_doubles.hpp"

namespace hsp::HSP_TARGET {

void angles_of_four(const double *x, const double *y, double *half_turn_angles, double *turn_angles) {
  Four::store(half_turn_angles, half_turn_angle<Four>(Four::load(x), Four::load(y)).sum());
  using L = Wide<double, register_lanes>;
  for (uint32_t k = 0; k < 4; k += register_lanes) {
    L::store(turn_angles + k, turn_angle<register_lanes>(L::load(x + k), L::load(y + k)));
  }
}

}  // namespace hsp::HSP_TARGET
