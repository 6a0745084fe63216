#include "maps/map_queries.hpp"

#include <cmath>
#include <limits>

#include "maps/curves.hpp"

namespace hsp {
namespace {

// The height of a ball's front at a point at or near its disc; of the silhouette beside it.
double front_at(const SeenBall &ball, double x, double y) {
  const double dx = x - ball.x;
  const double dy = y - ball.y;
  const double squared = ball.r * ball.r - dx * dx - dy * dy;
  return squared > 0.0 ? ball.z + std::sqrt(squared) : ball.z;
}

}  // namespace

MapSight sight_at(const VisibilityMap &map, const DiscGrid &grid, double x, double y) {
  const uint32_t ball = grid.highest_at(x, y, no_id).body;
  if (ball == no_id) return {no_id, -std::numeric_limits<double>::infinity()};
  return {ball, front_at(map.balls[ball], x, y)};
}

EdgePoint edge_point(const VisibilityMap &map, uint32_t e, double t) {
  const MapEdge &edge = map.edges[e];
  const SeenBall &ball = map.balls[edge.ball];
  const Vec3 at = edge.is_silhouette() ? silhouette_point(ball, t) : Crease(ball, map.balls[edge.nearer]).at(t);
  if (!edge.is_silhouette()) return {at.x, at.y, at.z, 0.0, 0.0};
  const uint32_t behind = map.faces[map.face_of(2 * e + 1)].owner;
  const double gap =
      behind == no_id ? std::numeric_limits<double>::infinity() : at.z - front_at(map.balls[behind], at.x, at.y);
  return {at.x, at.y, at.z, 0.0, gap > 0.0 ? gap : 0.0};
}

void sum_visible_areas(const VisibilityMap &map, Span<const uint32_t> caller, Span<double> area) {
  for (double &sum : area) sum = 0.0;
  for (const MapFace &face : map.faces.items()) {
    if (face.owner != no_id) area[caller[map.balls[face.owner].ball]] += face.area;
  }
}

uint32_t previous_half_edge(const VisibilityMap &map, uint32_t h) {
  uint32_t leaving = h;
  for (;;) {
    const uint32_t arriving = leaving ^ 1U;
    leaving = map.half_edges[arriving].next;
    if (leaving == h) return arriving;
  }
}

uint32_t next_loop(const VisibilityMap &map, uint32_t loop) {
  const MapLoop &of = map.loops[loop];
  return of.next_of_face != no_id ? of.next_of_face : map.faces[of.face].first_loop;
}

}  // namespace hsp
