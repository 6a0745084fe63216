#include "surface/degenerate_balls.hpp"

#include "exact/exact_predicates.hpp"

namespace hsp {
namespace {

// The plane of a ball, seen from another one, if their spheres meet.
bool find_plane(const exact::LatticeBall &own, const exact::LatticeBall &other, exact::Plane &plane) {
  if (exact::pair_relation(own, other) == exact::PairRelation::disjoint) return false;
  plane = exact::plane_of(own, other);
  const int64_t between = own.radius - other.radius;
  return !exact::is_zero(plane.v) && dot(plane.v, plane.v) >= between * between;
}

}  // namespace

bool passes_through_vertex(const BallSet &balls, const VertexRecord &vertex, uint32_t ball) {
  if (ball == vertex.ball[0] || ball == vertex.ball[1] || ball == vertex.ball[2]) return false;
  const exact::LatticeBall own = balls.ball(vertex.ball[0]);
  exact::Plane plane;
  if (!find_plane(own, balls.ball(ball), plane)) return false;
  return exact::Exact::point_status(exact::sphere_of(own), exact::plane_of(own, balls.ball(vertex.ball[1])),
                                    exact::plane_of(own, balls.ball(vertex.ball[2])), plane)
      .tied[vertex.positive() ? 1 : 0];
}

// Two planes are one iff their normals are parallel and q = h_P v - h_Q u is 0.
bool contains_circle(const BallSet &balls, uint32_t first, uint32_t second, uint32_t ball) {
  if (ball == first || ball == second) return false;
  const exact::LatticeBall own = balls.ball(first);
  exact::Plane plane;
  if (!find_plane(own, balls.ball(ball), plane)) return false;
  const exact::Plane of_circle = exact::plane_of(own, balls.ball(second));
  if (!exact::is_zero(cross(of_circle.v, plane.v))) return false;
  double q[3];
  exact::Exact::radical_vector(of_circle, plane, q);
  return q[0] == 0.0 && q[1] == 0.0 && q[2] == 0.0;
}

}  // namespace hsp
