#include "sphere/arc_geometry.hpp"

namespace hsp {
namespace {

// The centre of circle P relative to the ball's centre: h v / (2 |v|^2).
Vec3 circle_centre(const exact::Plane &P) {
  const double along = static_cast<double>(P.h) / (2 * static_cast<double>(dot(P.v, P.v)));
  const Vec3 v = exact::to_double(P.v);
  return {v.x * along, v.y * along, v.z * along};
}

}  // namespace

// p = (q x n + sign sqrt(D) n) / N, and the offset is p / 2. q is orthogonal to n, so that q x n has no cancellation.
void vertex_offset(const exact::Plane &P, const exact::Plane &Q, int sign, double root_D, double offset[3]) {
  const exact::Vector normal = cross(P.v, Q.v);
  const Vec3 n = exact::to_double(normal);
  double radical[3];
  exact::Exact::radical_vector(P, Q, radical);
  const Vec3 p = combine(1.0, cross({radical[0], radical[1], radical[2]}, n), sign > 0 ? root_D : -root_D, n);
  const double scale = 0.5 / dot(n, n);
  offset[0] = p.x * scale;
  offset[1] = p.y * scale;
  offset[2] = p.z * scale;
}

CircleGeometry circle_geometry(const BallSet &balls, uint32_t first, uint32_t second) {
  const exact::LatticeBall own = balls.ball(first);
  const exact::Plane P = exact::plane_of(own, balls.ball(second));
  const double U = static_cast<double>(dot(P.v, P.v));
  const double distance = std::sqrt(U);
  const Vec3 v = exact::to_double(P.v);
  const double Delta = exact::Exact::circle_discriminant(exact::sphere_of(own), P);
  const Vec3 centre = circle_centre(P);
  return {{centre.x, centre.y, centre.z},
          {v.x / distance, v.y / distance, v.z / distance},
          Delta > 0.0 ? std::sqrt(Delta / (4 * U)) : 0.0};
}

}  // namespace hsp
