#include "measure/areas.hpp"

#include "exact/filter.hpp"
#include "sphere/arc_geometry.hpp"

namespace hsp {
namespace {

BallMeasure measure(const BallSet &balls, const Boundary &boundary, uint32_t i, uint32_t face, uint32_t faces,
                    uint32_t loops) {
  const double radius = balls.r[i];
  FreeSurface surface(boundary, radius);
  ArcBatches arcs(balls, boundary, i, face);
  while (arcs.next()) surface.add(arcs.batch());
  BallMeasure result;
  result.area = radius * radius * surface.steradians(faces, loops);
  result.volume = volume_term(radius, result.area, offset_from_origin(balls, boundary, i), surface.vector_area());
  return result;
}

}  // namespace

double angle_of(const BallSet &balls, const Boundary &boundary, uint32_t ball, uint32_t half_edge) {
  const HalfEdge &start = boundary.half_edge(half_edge);
  const HalfEdge &end = boundary.half_edge(start.next);
  const exact::LatticeBall own = balls.ball(ball);
  const auto plane = [&](uint32_t j) { return exact::plane_of(own, balls.ball(j)); };
  return arc_angle(plane(start.circle), plane(end.circle), boundary.root_discriminant(end.vertex),
                   plane(boundary.previous_circle(ball, start)), boundary.root_discriminant(start.vertex));
}

BallMeasure measure_ball(const BallSet &balls, const Boundary &boundary, uint32_t i) {
  const uint32_t faces = boundary.faces(i).size();
  if (faces == 0) return {};
  return measure(balls, boundary, i, no_id, faces, boundary.loops(i).size());
}

BallMeasure measure_face(const BallSet &balls, const Boundary &boundary, uint32_t face) {
  return measure(balls, boundary, boundary.face(face).ball, face, 1, boundary.loops_of_face(face).size());
}

}  // namespace hsp
