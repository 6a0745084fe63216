#include "sphere/vertex_finder.hpp"

namespace hsp {
namespace {

// Whether one point of the circle surely lies inside another cap. The point is b u + s t with t a unit vector across u
// and s = sqrt(1 - b^2); t has error 8e (the cross product with the axis least along u is at least sqrt(2/3) long), s
// has error 9e/s + 2e, and the test against a cap adds 16e as in cap_pair.hpp, so that 40e + 16e/s bounds all.
bool a_point_is_surely_covered(const Caps &caps, const CapTests &tests, uint32_t j) {
  const double x = caps.ux[j], y = caps.uy[j], z = caps.uz[j], b = caps.b[j];
  const double squared = (1.0 - b) * (1.0 + b);
  if (!(squared > 0x1p-32)) return false;
  const double s = std::sqrt(squared);
  const double error = unit_roundoff * (40.0 + 16.0 / s);
  double tx = 0.0, ty = 0.0, tz = 0.0;
  if (x * x <= y * y && x * x <= z * z) {
    ty = z;
    tz = -y;
  } else if (y * y <= z * z) {
    tx = -z;
    tz = x;
  } else {
    tx = y;
    ty = -x;
  }
  const double scale = s / std::sqrt(tx * tx + ty * ty + tz * tz);
  const double px = b * x + scale * tx, py = b * y + scale * ty, pz = b * z + scale * tz;
  for (uint32_t t = 0; t < tests.count; ++t) {
    if (px * tests.ux[t] + py * tests.uy[t] + pz * tests.uz[t] - tests.b[t] > error) return true;
  }
  return false;
}

}  // namespace

// The circle is asked about when it may have vertices, but none with two later balls. If one point of it is covered, it
// is not free as a whole. Else it is free as a whole iff it crosses no other circle and lies inside no other cap.
bool is_free_circle(const Caps &caps, const CapTests &tests, uint32_t j) {
  if (a_point_is_surely_covered(caps, tests, j)) return false;
  const exact::Predicates predicates = caps.predicates();
  for (uint32_t t = 0; t < tests.count; ++t) {
    const uint32_t l = tests.cap[t];
    if (l == j) continue;
    if (predicates.crossing(caps.plane[j], caps.plane[l]).sign > 0) return false;
    if (predicates.side(caps.plane[j], caps.plane[l]).sign > 0) return false;
  }
  return true;
}

}  // namespace hsp
