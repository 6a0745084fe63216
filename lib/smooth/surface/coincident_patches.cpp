#include "surface/coincident_patches.hpp"

#include "surface/covered_gaps.hpp"

namespace hsp {
namespace {

// The half-edge that starts at a vertex on the circle of the two balls besides this one.
uint32_t half_edge_opposite(const Boundary &boundary, uint32_t vertex, uint32_t slot) {
  const uint32_t e = boundary.half_edge_at(vertex, (slot + 1) % 3);
  return boundary.half_edge(e).circle != boundary.vertex(vertex).ball[slot]
             ? e
             : boundary.half_edge_at(vertex, (slot + 2) % 3);
}

Vec3 crossing_near(const CircleCrossing<Vec3, double> &pair, const Vec3 &point) {
  const double D = pair.discriminant(1.0);
  const double root = D > 0.0 ? std::sqrt(D) : 0.0;
  return pair.point(dot(pair.n, point) > 0.0 ? root : -root);
}

}  // namespace

SeenTriangle::SeenTriangle(const BallSet &balls, const Boundary &boundary, const Position &position, uint32_t vertex) {
  Vec3 to[3];
  for (uint32_t t = 0; t < 3; ++t) {
    to[t] = balls.difference(position.ball, boundary.vertex(vertex).ball[t]) - position.offset;
  }
  for (uint32_t t = 0; t < 3; ++t) {
    const Vec3 normal = cross(to[(t + 1) % 3], to[(t + 2) % 3]);
    const double length = std::sqrt(dot(normal, normal));
    inward[t] = length > 0.0 ? (dot(normal, to[t]) < 0.0 ? -1.0 : 1.0) / length * normal : Vec3{0.0, 0.0, 0.0};
  }
}

uint32_t CoincidentPatches::across_cusps(uint32_t vertex, uint32_t slot) const {
  const VertexRecord &record = boundary_.vertex(vertex);
  const uint32_t a = slot == 0 ? 1 : 0;
  const uint32_t b = slot == 2 ? 1 : 2;
  if (cusped_.of_arc(record.ball[a], record.ball[b]) == no_id) return no_id;
  const uint32_t e = half_edge_opposite(boundary_, vertex, slot);
  return gap_behind(balls_, boundary_, chosen_, boundary_.ball_of(e), e).vertex;
}

double CoincidentPatches::depth_in(uint32_t vertex, const Vec3 &point, uint32_t besides) const {
  const SeenTriangle seen = triangle(vertex);
  const Vec3 to = point - way(probe_.vertex(), vertex);
  double least = 2.0;
  for (uint32_t slot = 0; slot < 3; ++slot) {
    const double above = dot(to, seen.inward[slot]);
    if (slot != besides && above < least) least = above;
  }
  return least;
}

uint32_t CoincidentPatches::vertex_at(uint32_t cap, const Vec3 &point) const {
  uint32_t best = probe_.caps().ball[cap];
  double deepest = -2.0;
  probe_.for_each_at_position(cap, [&](uint32_t vertex) {
    const double depth = depth_in(vertex, point);
    if (depth > deepest || (depth == deepest && vertex < best)) {
      deepest = depth;
      best = vertex;
    }
  });
  return best;
}

// The inward normal of the side between two vertices at one position, seen from the first; 0 if there is none.
Vec3 CoincidentPatches::normal_towards(uint32_t vertex, uint32_t opposite_probe) const {
  for (uint32_t slot = 0; slot < 3; ++slot) {
    if (across_cusps(vertex, slot) == opposite_probe) return triangle(vertex).inward[slot];
  }
  return {0.0, 0.0, 0.0};
}

// Seen from the lower one, with the others in their order.
uint32_t CoincidentPatches::owner_of_corner(uint32_t vertex, uint32_t opposite_probe, uint32_t a, uint32_t b,
                                            const Vec3 &point) const {
  const uint32_t lower = vertex < opposite_probe ? vertex : opposite_probe;
  const uint32_t upper = vertex < opposite_probe ? opposite_probe : vertex;
  const Vec3 first = way(lower, a < b ? a : b);
  const Vec3 second = way(lower, a < b ? b : a);
  const CircleCrossing<Vec3, double> pair(first, 0.5 * dot(first, first), second, 0.5 * dot(second, second));
  const Vec3 corner = crossing_near(pair, point - way(probe_.vertex(), lower));
  return dot(normal_towards(lower, upper), corner) > 0.0 ? lower : upper;
}

// Along the circle in which the two spheres meet one of the sides comes first. Seen from the pair with the lowest
// vertex.
uint32_t CoincidentPatches::owner_on_side(uint32_t vertex, uint32_t opposite_probe, uint32_t first, uint32_t second,
                                          const Vec3 &point) const {
  const bool own_is_lower = (vertex < opposite_probe ? vertex : opposite_probe) < (first < second ? first : second);
  const uint32_t a = own_is_lower ? vertex : first;
  const uint32_t b = own_is_lower ? opposite_probe : second;
  const uint32_t c = own_is_lower ? first : vertex;
  const uint32_t d = own_is_lower ? second : opposite_probe;
  const uint32_t lower = a < b ? a : b;
  const uint32_t upper = a < b ? b : a;
  const uint32_t other_lower = c < d ? c : d;
  const uint32_t other_upper = c < d ? d : c;
  const Vec3 normal = normal_towards(lower, upper);
  const Vec3 other_normal = normal_towards(other_lower, other_upper);
  const Vec3 to = way(lower, other_lower);
  const CircleCrossing<Vec3, double> pair(normal, 0.0, to, 0.5 * dot(to, to));
  const Vec3 corner = crossing_near(pair, point - way(probe_.vertex(), lower));
  const bool on_lower_side = dot(other_normal, corner - to) > 0.0;
  if (own_is_lower) return on_lower_side ? other_lower : other_upper;
  const Vec3 along = cross(to, corner);
  const bool same_way = (dot(normal, along) > 0.0) == (dot(other_normal, along) > 0.0);
  return on_lower_side != same_way ? lower : upper;
}

}  // namespace hsp
