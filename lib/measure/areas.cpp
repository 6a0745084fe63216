#include "measure/areas.hpp"

#include "exact/filter.hpp"
#include "sphere/arc_geometry.hpp"
#include "measure/free_surface.hpp"

namespace hsp {
namespace {

using exact::DoubleVector;

// The centre of circle P relative to the ball's centre: h v / (2 |v|^2).
DoubleVector circle_centre(const exact::Plane &P) {
  const double along = static_cast<double>(P.h) / (2 * static_cast<double>(exact::dot(P.v, P.v)));
  const DoubleVector v = exact::to_double(P.v);
  return {v.x * along, v.y * along, v.z * along};
}

BallMeasure measure(const BallSet &balls, const BoundaryStructure &boundary, uint32_t i, uint32_t face, uint32_t faces,
                    uint32_t loops) {
  const double radius = balls.r[i];
  FreeSurface surface(radius);
  FreeArcs arcs(balls, boundary, i, face);
  while (arcs.next()) surface.add(arcs.batch());
  BallMeasure result;
  result.area = radius * radius * surface.steradians(faces, loops, arcs.exteriors());
  result.volume = (radius * result.area + exact::dot(arm_of(balls, boundary, i), surface.vector_area())) / 3;
  return result;
}

}  // namespace

// p = (q x n + sign sqrt(D) n) / N, and the offset is p / 2. q is orthogonal to n, so that q x n has no cancellation.
void vertex_offset(const exact::Plane &P, const exact::Plane &Q, int sign, double root_D, double offset[3]) {
  const exact::Vector normal = exact::cross(P.v, Q.v);
  const DoubleVector n = exact::to_double(normal);
  double radical[3];
  exact::Exact::radical_vector(P, Q, radical);
  const DoubleVector p =
      exact::combine(1.0, exact::cross({radical[0], radical[1], radical[2]}, n), sign > 0 ? root_D : -root_D, n);
  const double scale = 0.5 / exact::dot(n, n);
  offset[0] = p.x * scale;
  offset[1] = p.y * scale;
  offset[2] = p.z * scale;
}

CirclePlace circle_place(const BallSet &balls, uint32_t first, uint32_t second) {
  const exact::LatticeBall own = balls.ball(first);
  const exact::Plane P = exact::plane_of(own, balls.ball(second));
  const double U = static_cast<double>(exact::dot(P.v, P.v));
  const double distance = std::sqrt(U);
  const DoubleVector v = exact::to_double(P.v);
  const double Delta = exact::Exact::circle_discriminant(exact::sphere_of(own), P);
  const DoubleVector centre = circle_centre(P);
  return {{centre.x, centre.y, centre.z},
          {v.x / distance, v.y / distance, v.z / distance},
          Delta > 0.0 ? std::sqrt(Delta / (4 * U)) : 0.0};
}

double arc_angle(const BallSet &balls, const BoundaryStructure &boundary, uint32_t ball, uint32_t use) {
  const VertexUse &walk = boundary.uses[use];
  const VertexUse &end = boundary.uses[walk.next];
  const exact::LatticeBall own = balls.ball(ball);
  const auto plane = [&](uint32_t j) { return exact::plane_of(own, balls.ball(j)); };
  return FreeArc(plane(walk.out), plane(end.out), boundary.root_discriminant[end.vertex], plane(walk.in),
                 boundary.root_discriminant[walk.vertex])
      .angle();
}

BallMeasure measure_ball(const BallSet &balls, const BoundaryStructure &boundary, uint32_t i) {
  const uint32_t faces = boundary.first_face[i + 1] - boundary.first_face[i];
  if (faces == 0) return {};
  return measure(balls, boundary, i, no_id, faces, boundary.first_loop[i + 1] - boundary.first_loop[i]);
}

BallMeasure measure_face(const BallSet &balls, const BoundaryStructure &boundary, uint32_t face) {
  const FaceRecord &record = boundary.faces[face];
  return measure(balls, boundary, record.ball, face, 1, record.loops);
}

}  // namespace hsp
