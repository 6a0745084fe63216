#include "visibility/edge_geometry.hpp"

#include <initializer_list>

namespace hsp {
namespace {

// How often an edge meets the ray from (x, y) to the right.
uint32_t crossings(const VisibilityMap &map, const MapEdge &edge, double x, double y) {
  const EdgeEllipse ellipse(map.balls, edge);
  const double c = ellipse.first[1];
  const double s = ellipse.second[1];
  const double height = y - ellipse.centre[1];
  const double squared = c * c + s * s - height * height;
  if (squared <= 0.0) return 0;
  const double middle = arc_tangent(s, c);
  const double half = arc_tangent(std::sqrt(squared), height);
  uint32_t count = 0;
  for (double t : {middle - half, middle + half}) {
    while (t >= edge.from) t -= 2 * pi;
    while (t < edge.from) t += 2 * pi;
    if (t < edge.to && ellipse.x(sin_cos(t)) > x) ++count;
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
