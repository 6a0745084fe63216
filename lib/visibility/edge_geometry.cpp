#include "visibility/edge_geometry.hpp"

#include <initializer_list>

namespace hsp {
namespace {

// The cosine and sine of 1: a direction in which no two vertices of a scene that somebody has made up lie. A vertex on
// the ray may count for both of its edges, or for none, as roundings will have it.
constexpr double ray_x = 0.5403023058681398, ray_y = 0.8414709848078965;

double beside(const double v[2]) {
  return ray_x * v[1] - ray_y * v[0];
}

// How often an edge meets the ray from (x, y).
uint32_t crossings(const VisibilityMap &map, const MapEdge &edge, double x, double y) {
  const EdgeEllipse ellipse(map.balls, edge);
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
    while (t >= edge.from) t -= 2 * pi;
    while (t < edge.from) t += 2 * pi;
    if (t >= edge.to) continue;
    const SinCos at = sin_cos(t);
    if (ray_x * (ellipse.x(at) - x) + ray_y * (ellipse.y(at) - y) > 0.0) ++count;
  }
  return count;
}

}  // namespace

bool surrounds(const VisibilityMap &map, uint32_t loop, double x, double y) {
  uint32_t count = 0;
  const uint32_t first = map.loops[loop].first_half_edge;
  uint32_t h = first;
  do {
    count += crossings(map, map.edges[h / 2], x, y);
    h = map.half_edges[h].next;
  } while (h != first);
  return count % 2 == 1;
}

}  // namespace hsp
