// Makes edges that a triangulation of a sphere must have.
#include "mesh/sphere_triangulation.hpp"

namespace hsp {

// Gathers the edges that cross the edge from a to b, from a on. False if a point or a fixed edge is in the way.
bool SphereTriangulation::gather_crossings(uint32_t a, uint32_t b, uint32_t &obstacle) {
  crossings_ = 0;
  const uint32_t first = triangle_at_[a];
  uint32_t t = first;
  for (;;) {  // around a, until b lies between two edges
    const SphereTriangle &triangle = triangle_[t];
    const uint32_t corner = triangle.corner_of(a);
    const uint32_t p = triangle.point[next_corner(corner)];
    const uint32_t q = triangle.point[previous_corner(corner)];
    const int from_p = side(a, p, b);
    if (from_p == 0 && side(a, b, q) > 0) {
      obstacle = p;
      return false;
    }
    if (from_p > 0 && side(a, b, q) > 0) break;
    t = triangle.neighbour[next_corner(corner)];
    if (t == first) {
      obstacle = p;
      return false;
    }
  }
  uint32_t edge = triangle_[t].corner_of(a);
  for (uint32_t step = 0; step < triangle_count_; ++step) {
    const SphereTriangle &triangle = triangle_[t];
    const uint32_t right = triangle.point[next_corner(edge)];
    const uint32_t left = triangle.point[previous_corner(edge)];
    if (triangle.fixed[edge]) {
      obstacle = right;
      other_obstacle_ = left;
      return false;
    }
    crossing_[crossings_++] = {right, left};
    const uint32_t u = triangle.neighbour[edge];
    const uint32_t back = triangle_[u].edge_towards(t);
    const uint32_t y = triangle_[u].point[back];
    if (y == b) return true;
    const int at = side(a, b, y);
    if (at == 0) {
      obstacle = y;
      return false;
    }
    // In u the corners after y are left and right. The line leaves u between y and the one of them on its other side.
    edge = at > 0 ? triangle_[u].corner_of(left) : triangle_[u].corner_of(right);
    t = u;
  }
  obstacle = b;
  return false;
}

// Sloan, Advances in Engineering Software 15 (1993), 133: edges that cross are flipped in turn where that is possible,
// until none does.
bool SphereTriangulation::fix_edge(uint32_t a, uint32_t b, uint32_t &obstacle) {
  TriangleEdge found;
  other_obstacle_ = no_id;
  if (!find_edge(a, b, found)) {
    if (!gather_crossings(a, b, obstacle)) return false;
    flipped_ = true;
    const uint32_t ring = crossing_.size();
    uint32_t head = 0;
    uint32_t waiting = crossings_;
    const uint64_t most_tries = 64 + 4 * uint64_t{crossings_} * crossings_;
    for (uint64_t tries = 0; waiting > 0 && tries < most_tries; ++tries) {
      const Pair pair = crossing_[head];
      head = head + 1 < ring ? head + 1 : 0;
      --waiting;
      if (!find_edge(pair.a, pair.b, found)) break;
      const uint32_t u = triangle_[found.triangle].neighbour[found.edge];
      Pair next = pair;
      bool crosses = true;
      if (may_flip(found.triangle, found.edge)) {
        next.a = triangle_[found.triangle].point[found.edge];
        next.b = triangle_[u].point[triangle_[u].edge_towards(found.triangle)];
        flip(found.triangle, found.edge);
        const bool at_end = next.a == a || next.a == b || next.b == a || next.b == b;
        crosses = !at_end && side(a, b, next.a) * side(a, b, next.b) < 0;
      }
      if (!crosses) continue;
      const uint32_t slot = head + waiting;
      crossing_[slot < ring ? slot : slot - ring] = next;
      ++waiting;
    }
    if (!find_edge(a, b, found)) {
      obstacle = b;
      return false;
    }
  }
  triangle_[found.triangle].fixed[found.edge] = true;
  const uint32_t u = triangle_[found.triangle].neighbour[found.edge];
  triangle_[u].fixed[triangle_[u].edge_towards(found.triangle)] = true;
  return true;
}

}  // namespace hsp
