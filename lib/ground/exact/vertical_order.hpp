// The exact order of the points where a vertical line enters spheres. Sums of two square roots are compared by squaring
// twice (degree 4).
#pragma once

#include "exact/lattice_ball.hpp"
#include "exact/power.hpp"

namespace hsp::exact {

// Sign of E + T sqrt(b) for |E| < 2^63, |T| < 2^31, 0 <= b < 2^60.
inline int sign_with_root(int64_t E, int64_t T, int64_t b) {
  const int sign_E = (E > 0) - (E < 0);
  const int sign_T = b == 0 ? 0 : (T > 0) - (T < 0);
  if (sign_E == 0 || sign_T == 0 || sign_E == sign_T) return sign_E != 0 ? sign_E : sign_T;
  return sign_E * (times<FastLimb>(E, E) - times<FastLimb>(T * T, b)).sign();
}

// Sign of (z_a - sqrt(a)) - (z_b - sqrt(b)) for z = z_a - z_b, |z| <= 2^51 and 0 <= a, b < 2^60.
inline int compare_entries(int64_t z, int64_t a, int64_t b) {
  constexpr int64_t beyond_roots = INT64_C(1) << 30;
  if (z >= beyond_roots) return 1;
  if (z <= -beyond_roots) return -1;
  // Compares z + sqrt(b) with sqrt(a).
  const int side = sign_with_root(z, 1, b);
  if (side < 0) return -1;
  if (side == 0) return a > 0 ? -1 : 0;
  return sign_with_root(z * z + b - a, 2 * z, b);
}

// The part of a vertical line inside a ball, measured upwards from a point of the line.
struct VerticalCut {
  int64_t below;  // height of the ball's centre above the point
  int64_t power;  // r^2 - distance^2 of the line: the line is inside from below - sqrt(power) to below + sqrt(power)
};

// False if the line misses the closed ball.
inline bool cut_vertically(const Vector &point, const LatticeBall &ball, VerticalCut &cut) {
  const int64_t dx = ball.centre.x - point.x;
  const int64_t dy = ball.centre.y - point.y;
  const int64_t r = ball.radius;
  if (dx > r || dy > r || -dx > r || -dy > r) return false;
  cut = {ball.centre.z - point.z, r * r - dx * dx - dy * dy};
  return cut.power >= 0;
}

}  // namespace hsp::exact
