#include "maps/edge_distance.hpp"

#include "maps/trigonometric_roots.hpp"

namespace hsp {
namespace {

void look_along_line(const EdgeEllipse &line, double x, double y, NearestPoint &nearest) {
  const double *const half = line.first;
  const double squared = half[0] * half[0] + half[1] * half[1];
  const double along = (x - line.centre[0]) * half[0] + (y - line.centre[1]) * half[1];
  if (!(std::fabs(along) < squared)) return;  // its ends are as near as all
  const double part = along / squared;
  look_at_point(line.centre[0] + part * half[0], line.centre[1] + part * half[1], x, y, nearest);
}

void look_along_circle(const EdgeCurve &curve, double x, double y, NearestPoint &nearest) {
  const EdgeEllipse &circle = curve.ellipse;
  const double dx = x - circle.centre[0];
  const double dy = y - circle.centre[1];
  const double squared = dx * dx + dy * dy;
  if (squared == 0.0) return;  // its ends are as near as all
  double t = arc_tangent(dy, dx);
  while (t >= curve.from) t -= 2 * pi;
  while (t < curve.from) t += 2 * pi;
  const double scale = circle.first[0] / std::sqrt(squared);
  if (t <= curve.to) look_at_point(circle.centre[0] + scale * dx, circle.centre[1] + scale * dy, x, y, nearest);
}

// Half the derivative of the squared distance is B cos t - A sin t - K sin t cos t, where A and B are the products of
// the vector from the point to the centre with both semi-axes, and K the difference of the squares of these. At an
// angle of pi / 4 less the product becomes a square: sin t cos t = cos^2 s - 1/2 for t = s + pi / 4.
void look_along_ellipse(const EdgeCurve &curve, double x, double y, NearestPoint &nearest) {
  constexpr double eighth = 0.25 * pi, root_half = 0.7071067811865476;
  const EdgeEllipse &ellipse = curve.ellipse;
  const double wx = ellipse.centre[0] - x;
  const double wy = ellipse.centre[1] - y;
  const double *const p = ellipse.first;
  const double *const q = ellipse.second;
  const double A = wx * p[0] + wy * p[1];
  const double B = wx * q[0] + wy * q[1];
  const double K = p[0] * p[0] + p[1] * p[1] - q[0] * q[0] - q[1] * q[1];
  const TrigonometricPolynomial slope{0.5 * K, root_half * (B - A), -root_half * (A + B), -K};
  double root[most_trigonometric_roots];
  const uint32_t count = find_roots(slope, curve.from - eighth, curve.to - eighth, root);
  for (uint32_t k = 0; k < count; ++k) {
    const SinCos t = sin_cos(root[k] + eighth);
    look_at_point(ellipse.x(t), ellipse.y(t), x, y, nearest);
  }
}

}  // namespace

void look_at_point(double to_x, double to_y, double x, double y, NearestPoint &nearest) {
  const double dx = to_x - x;
  const double dy = to_y - y;
  const double squared = dx * dx + dy * dy;
  if (squared < nearest.squared) nearest = {to_x, to_y, squared};
}

void look_along(const EdgeCurve &curve, bool silhouette, double x, double y, NearestPoint &nearest) {
  const double *const second = curve.ellipse.second;
  if (second[0] == 0.0 && second[1] == 0.0) {
    look_along_line(curve.ellipse, x, y, nearest);
  } else if (silhouette) {
    look_along_circle(curve, x, y, nearest);
  } else {
    look_along_ellipse(curve, x, y, nearest);
  }
}

}  // namespace hsp
