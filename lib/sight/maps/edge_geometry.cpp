#include "maps/edge_geometry.hpp"

#include <initializer_list>

namespace hsp {
namespace {

// The cosine and sine of 1: a direction in which no two vertices of a scene that somebody has made up lie. A vertex on
// the ray may count for both of its edges, or for none, as roundings will have it.
constexpr double ray_x = 0.5403023058681398, ray_y = 0.8414709848078965;

double beside(const double v[2]) {
  return ray_x * v[1] - ray_y * v[0];
}

}  // namespace

uint32_t crossings(const EdgeCurve &curve, double x, double y) {
  const EdgeEllipse &ellipse = curve.ellipse;
  const double c = beside(ellipse.first);
  const double s = beside(ellipse.second);
  const double from_centre[2] = {x - ellipse.centre[0], y - ellipse.centre[1]};
  const double height = beside(from_centre);
  const double squared = c * c + s * s - height * height;
  if (squared <= 0.0) return 0;
  const double middle = arc_tangent(s, c);
  const double half = arc_tangent(std::sqrt(squared), height);
  uint32_t count = 0;
  for (double t : {middle - half, middle + half}) {
    while (t >= curve.from) t -= 2 * pi;
    while (t < curve.from) t += 2 * pi;
    if (t >= curve.to) continue;
    const SinCos at = sin_cos(t);
    if (ray_x * (ellipse.x(at) - x) + ray_y * (ellipse.y(at) - y) > 0.0) ++count;
  }
  return count;
}

}  // namespace hsp
