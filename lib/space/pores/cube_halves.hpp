// Which balls may be nearest in the eight parts of a cube, as numbers side by side: for registers of n doubles, which
// all find the same bits.
#pragma once

#include <limits>

#include "lanes/target.hpp"
#include "lanes/wide.hpp"

namespace hsp {

// Some balls.
struct NearArrays {
  const double *x, *y, *z, *radius;
  const uint32_t *ball;
  uint32_t count;
};
// The parts of a cube by their middles: axis k has bit k of their number.
struct CubeParts {
  double x[8], y[8], z[8];
  double edge;           // half the edge of one
  uint32_t nearest[8];   // the ball with the least distance from the middle
  double most_level[8];  // which no distance of the nearest ball in the part is above
};

// Sets `nearest`.
HSP_KERNEL(void, find_nearest, (const NearArrays &near, CubeParts &parts), (near, parts))
// Sets a bit for each part in which a ball may be at least as near as most_level.
HSP_KERNEL(void, find_near, (const NearArrays &near, const CubeParts &parts, uint8_t *in), (near, parts, in))

namespace {

template <uint32_t n>
inline void find_nearest_in_lanes(const NearArrays &near, CubeParts &parts) {
  using L = Wide<double, n>;
  using Real = typename L::Real;
  constexpr uint32_t registers = 8 / n;
  Real x[registers], y[registers], z[registers], least[registers], which[registers];
  for (uint32_t k = 0; k < registers; ++k) {
    x[k] = L::load(parts.x + k * n);
    y[k] = L::load(parts.y + k * n);
    z[k] = L::load(parts.z + k * n);
    least[k] = L::all(std::numeric_limits<double>::infinity());
    which[k] = L::all(0.0);
  }
  for (uint32_t i = 0; i < near.count; ++i) {
    const uint32_t ball = near.ball[i];
    const Real ball_x = L::all(near.x[ball]), ball_y = L::all(near.y[ball]), ball_z = L::all(near.z[ball]);
    const Real radius = L::all(near.radius[ball]), own = L::all(static_cast<double>(ball));
    for (uint32_t k = 0; k < registers; ++k) {
      const Real dx = ball_x - x[k], dy = ball_y - y[k], dz = ball_z - z[k];
      const Real gap = L::square_root(dx * dx + dy * dy + dz * dz) - radius;
      const typename L::Mask nearer = gap < least[k];
      least[k] = L::select(nearer, gap, least[k]);
      which[k] = L::select(nearer, own, which[k]);
    }
  }
  for (uint32_t k = 0; k < 8; ++k) parts.nearest[k] = static_cast<uint32_t>(which[k / n][k % n]);
}

template <uint32_t n>
inline void find_near_in_lanes(const NearArrays &near, const CubeParts &parts, uint8_t *in) {
  using L = Wide<double, n>;
  using Real = typename L::Real;
  constexpr uint32_t registers = 8 / n;
  Real x[registers], y[registers], z[registers], most[registers];
  for (uint32_t k = 0; k < registers; ++k) {
    x[k] = L::load(parts.x + k * n);
    y[k] = L::load(parts.y + k * n);
    z[k] = L::load(parts.z + k * n);
    most[k] = L::load(parts.most_level + k * n);
  }
  const Real edge = L::all(parts.edge), zero = L::all(0.0), below = L::all(1.0 - 0x1p-48);
  const auto beyond = [&](const Real &from, const Real &to) { return L::larger(L::absolute(from - to) - edge, zero); };
  for (uint32_t i = 0; i < near.count; ++i) {
    const uint32_t ball = near.ball[i];
    const Real ball_x = L::all(near.x[ball]), ball_y = L::all(near.y[ball]), ball_z = L::all(near.z[ball]);
    const Real radius = L::all(near.radius[ball]);
    uint64_t found = 0;
    for (uint32_t k = 0; k < registers; ++k) {
      const Real dx = beyond(ball_x, x[k]), dy = beyond(ball_y, y[k]), dz = beyond(ball_z, z[k]);
      const Real within = L::larger(most[k] + radius, zero);
      found |= L::set_lanes((dx * dx + dy * dy + dz * dz) * below <= within * within) << k * n;
    }
    in[i] = static_cast<uint8_t>(found);
  }
}

}  // namespace
}  // namespace hsp
