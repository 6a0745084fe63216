// Kernels that find which balls may be nearest in the eight parts of a cube, for registers of n doubles. Every n gives
// the same bits.
#pragma once

#include <limits>

#include "lanes/target.hpp"
#include "lanes/wide.hpp"

namespace hsp {

// Some balls: the numbers ball[0 .. count - 1] into the arrays of coordinates and radii.
struct NearArrays {
  const double *x, *y, *z, *radius;
  const uint32_t *ball;
  uint32_t count;
};
// The eight parts of a cube, by their middles. Bit k of the number of a part tells its side along axis k.
struct CubeParts {
  double x[8], y[8], z[8];
  double edge;           // half the edge of a part
  uint32_t nearest[8];   // the ball with the least distance from the middle
  double most_level[8];  // upper bound of the distance to the nearest ball in the part
};

// A few balls as seen from the middle of a cube.
struct ViewedBalls {
  static constexpr uint32_t room = 64;
  double x[room], y[room], z[room];     // from the centre to the middle
  double ax[room], ay[room], az[room];  // the same as unit vectors; 0 in the centre
  double inverse[room];                 // of the length
  double gap[room];                     // distance from the ball to the middle
  double curve[room];                   // in the cube the distance is at most so much above its linear part
  double rounding[room];
  uint64_t farther[room];  // of each ball a bit for each other one that is farther in all of the cube
  double side;             // half an edge of the cube, and a little more
  double extent;           // the largest |x| + |y| + |z| of all balls
};
// Bound of the relative errors of unit vectors in doubles, and of what is computed from a few of them.
inline constexpr double slack_of_seen = 1e-12;
inline constexpr double root_of_three = 1.7320508075688774;

// Sets all arrays of `seen` but `farther`, and `extent`, for balls around a point. `side` is set before.
HSP_KERNEL(void, see, (const NearArrays &near, const double *at, ViewedBalls &seen), (near, at, seen))
// Returns a bit for each of `count` balls that is farther than another one in the whole cube. Sets `farther`; that of a
// ball which is known to be farther before its turn stays 0.
HSP_KERNEL(uint64_t, find_farther, (ViewedBalls & seen, uint32_t count), (seen, count))

// Sets parts.nearest.
HSP_KERNEL(void, find_nearest, (const NearArrays &near, CubeParts &parts), (near, parts))
// Sets a bit of in[k] for each part in which ball k may be at least as near as most_level.
HSP_KERNEL(void, find_near, (const NearArrays &near, const CubeParts &parts, uint8_t *in), (near, parts, in))

namespace {

template <uint32_t n>
inline void find_nearest_in_lanes(const NearArrays &near, CubeParts &parts) {
  using L = Wide<double, n>;
  using Real = typename L::Real;
  constexpr uint32_t registers = 8 / n;
  constexpr double infinite = std::numeric_limits<double>::infinity();  // a call would be compiled for the target
  Real x[registers], y[registers], z[registers], least[registers], which[registers];
  for (uint32_t k = 0; k < registers; ++k) {
    x[k] = L::load(parts.x + k * n);
    y[k] = L::load(parts.y + k * n);
    z[k] = L::load(parts.z + k * n);
    least[k] = L::all(infinite);
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

template <uint32_t n>
inline void see_in_lanes(const NearArrays &near, const double *at, ViewedBalls &seen) {
  using L = Wide<double, n>;
  using Real = typename L::Real;
  const double reach = root_of_three * seen.side;
  const Real at_x = L::all(at[0]), at_y = L::all(at[1]), at_z = L::all(at[2]), zero = L::all(0.0), one = L::all(1.0);
  const Real sagitta = L::all(0.5001 * reach * reach), reaches = L::all(reach), clear = L::all(1.001 * reach);
  const Real whole = L::all(2.0 * reach), slack = L::all(slack_of_seen);
  Real extent = zero;
  for (uint32_t first = 0; first < near.count; first += n) {
    uint32_t ball[n];
    for (uint32_t k = 0; k < n; ++k) ball[k] = near.ball[first + k < near.count ? first + k : near.count - 1];
    const Real x = at_x - L::gather(near.x, ball), y = at_y - L::gather(near.y, ball);
    const Real z = at_z - L::gather(near.z, ball), radius = L::gather(near.radius, ball);
    const Real length = L::square_root(x * x + y * y + z * z);
    const Real inverse = L::kept(length > zero, one / length);
    const Real rounding = slack * (length + radius);
    extent = L::larger(extent, L::absolute(x) + L::absolute(y) + L::absolute(z));
    L::store(seen.x + first, x);
    L::store(seen.y + first, y);
    L::store(seen.z + first, z);
    L::store(seen.ax + first, inverse * x);
    L::store(seen.ay + first, inverse * y);
    L::store(seen.az + first, inverse * z);
    L::store(seen.inverse + first, inverse);
    L::store(seen.gap + first, length - radius);
    L::store(seen.rounding + first, rounding);
    L::store(seen.curve + first, L::select(length > clear, sagitta / (length - reaches), whole) + rounding);
  }
  seen.extent = 0.0;
  for (uint32_t k = 0; k < n; ++k) seen.extent = extent[k] > seen.extent ? extent[k] : seen.extent;
}

template <uint32_t n>
inline uint64_t find_farther_in_lanes(ViewedBalls &seen, uint32_t count) {
  using L = Wide<double, n>;
  using Real = typename L::Real;
  const Real side = L::all(seen.side * (1.0 + slack_of_seen));
  uint32_t nearest = 0;
  double most = seen.gap[0];
  for (uint32_t k = 1; k < count; ++k) {
    nearest = seen.gap[k] < seen.gap[nearest] ? k : nearest;
    most = seen.gap[k] > most ? seen.gap[k] : most;
  }
  const uint64_t all = ~UINT64_C(0) >> (64 - count);
  uint64_t any = 0;
  for (uint32_t turn = 0; turn <= count; ++turn) {
    const uint32_t m = turn == 0 ? nearest : turn - 1;
    if (turn > 0 && m == nearest) continue;
    seen.farther[m] = 0;
    if ((any >> m & 1) != 0 || !(most - seen.gap[m] > seen.curve[m])) continue;
    const Real gap = L::all(seen.gap[m]), curve = L::all(seen.curve[m]);
    const Real ax = L::all(seen.ax[m]), ay = L::all(seen.ay[m]), az = L::all(seen.az[m]);
    uint64_t found = 0;
    for (uint32_t first = 0; first < count; first += n) {
      const Real apart = L::absolute(L::load(seen.ax + first) - ax) + L::absolute(L::load(seen.ay + first) - ay) +
                         L::absolute(L::load(seen.az + first) - az);
      const Real least = side * apart + curve + L::load(seen.rounding + first);
      found |= L::set_lanes(L::load(seen.gap + first) - gap > least) << first;
    }
    seen.farther[m] = found & all;
    any |= seen.farther[m];
  }
  return any;
}

}  // namespace
}  // namespace hsp
