#include "surface/surface_patches.hpp"

#include "measure/areas.hpp"
#include "sphere/arc_geometry.hpp"
#include "surface/saddle.hpp"

namespace hsp {
namespace {

// With R the radius with probe and r without, face and vector area shrink by (r / R)^2.
PatchMeasure measure_convex(const BallSet &balls, const Boundary &boundary, uint32_t face) {
  const uint32_t ball = boundary.face(face).ball;
  const BallMeasure whole = measure_face(balls, boundary, face);
  const double R = balls.r[ball];
  const double r = R - static_cast<double>(balls.probe_steps);
  const double shrinkage = R > 0.0 ? r / R * (r / R) : 0.0;
  return {shrinkage * whole.area, shrinkage * (whole.volume - (R - r) * whole.area / 3),
          boundary.component_origin(ball)};
}

struct SaddleMeasure {
  double area = 0.0;
  double triple_volume = 0.0;  // three times the term of the divergence theorem
};

// The part of a saddle patch that belongs to one of its balls, as saddle_kernel.hpp has it for all arcs of a ball;
// `chord` from the start of the arc to its end, as it runs about the axis away from this ball. With T, S, Q, C2 and SC
// the integrals of 1, cos, sin, cos^2 and sin cos over the profile, rho the circle's radius and p the probe,
//   area         phi p (rho T - p S)
//   vector area  p [ (S - p C2 / rho) chord x u - phi (rho Q - p SC) u ]
//   integral of (x - m).n   phi p [ (rho^2 + p^2) S - rho p (C2 + T) ]
SaddleMeasure measure_side(const BallSet &balls, const Boundary &boundary, uint32_t own, uint32_t other, double angle,
                           const Vec3 &chord) {
  const CircleGeometry circle(balls, own, other);
  const double other_height = CircleGeometry(balls, other, own).height;
  const double rho = circle.radius;
  const double p = static_cast<double>(balls.probe_steps);
  if (!(circle.height > 0.0) || !(rho > 0.0)) return {};
  const double sin_a = -circle.height / balls.r[own];
  const double cos_a = rho / balls.r[own];
  double sin_b = 0.0;
  double cos_b = 1.0;
  if (has_cusps(p, rho, circle.height, other_height)) {
    sin_b = -std::sqrt((p - rho) * (p + rho)) / p;
    cos_b = rho / p;
  } else if (other_height < 0.0) {
    sin_b = other_height / balls.r[other];
    cos_b = rho / balls.r[other];
  }
  const double T = arc_tangent(sin_b * cos_a - cos_b * sin_a, cos_b * cos_a + sin_b * sin_a);
  if (!(T > 0.0)) return {};
  const double S = sin_b - sin_a;
  const double Q = cos_a - cos_b;
  const double C2 = 0.5 * (T + sin_b * cos_b - sin_a * cos_a);
  const double SC = 0.5 * (sin_b - sin_a) * (sin_b + sin_a);
  const double area = angle * p * (rho * T - p * S);
  const double about_centre = angle * p * ((rho * rho + p * p) * S - rho * p * (C2 + T));
  const Vec3 vector_area =
      combine(p * (S - p * C2 / rho), cross(chord, circle.axis), -p * angle * (rho * Q - p * SC), circle.axis);
  const Vec3 arm = offset_from_origin(balls, boundary, own) + circle.centre;
  return {area > 0.0 ? area : 0.0, about_centre + dot(arm, vector_area)};
}

PatchMeasure sum_of_sides(const SaddleMeasure &a, const SaddleMeasure &b, uint32_t origin) {
  return {a.area + b.area, (a.triple_volume + b.triple_volume) / 3, origin};
}

PatchMeasure measure_arc(const BallSet &balls, const Boundary &boundary, uint32_t half_edge, bool both_sides) {
  const uint32_t own = boundary.ball_of(half_edge);
  const uint32_t other = boundary.half_edge(half_edge).circle;
  const double angle = angle_of_arc(balls, boundary, half_edge);
  // The half-edge runs clockwise about the axis away from its ball.
  const Position start = position_of_vertex(balls, boundary, boundary.end_vertex(half_edge));
  const Position end = position_of_vertex(balls, boundary, boundary.half_edge(half_edge).vertex);
  const Vec3 chord = balls.difference(start.ball, end.ball) + (end.offset - start.offset);
  const SaddleMeasure first = measure_side(balls, boundary, own, other, angle, chord);
  const SaddleMeasure second = both_sides ? measure_side(balls, boundary, other, own, angle, -chord) : SaddleMeasure{};
  return sum_of_sides(first, second, boundary.component_origin(own));
}

}  // namespace

PatchMeasure measure_patch(const BallSet &balls, const Boundary &boundary, const Surface &surface, uint32_t patch) {
  const SurfaceMap map(balls, boundary, surface);
  const SurfacePatch record = map.patch(patch);
  const CuspedCircles &cusped = surface.cusped_circles();
  if (record.kind == PatchKind::convex) return measure_convex(balls, boundary, record.source);
  if (record.kind == PatchKind::concave) {
    const uint32_t origin = boundary.component_origin(boundary.vertex(record.source).ball[0]);
    if (record.part == no_id) {
      const ConcavePatch &whole = surface.patch(record.source);
      return {whole.area, whole.volume, origin};
    }
    const PatchPiece &piece = surface.cut_patches().piece(record.part);
    return {piece.area, piece.volume, origin};
  }
  if (balls.probe_steps == 0) return {};
  if (record.kind == PatchKind::saddle) {
    const uint32_t half_edge = map.half_edge_of(record.source, record.part);
    return measure_arc(balls, boundary, half_edge, map.cusped_circle_of(half_edge) == no_id);
  }
  const CircleRecord &circle = boundary.circle(record.source);
  const bool in_order = balls.given_before(circle.ball[0], circle.ball[1]);
  const uint32_t own = circle.ball[in_order == (record.part == 0) ? 0 : 1];
  const uint32_t other = own == circle.ball[0] ? circle.ball[1] : circle.ball[0];
  const Vec3 none{0.0, 0.0, 0.0};
  const bool both_sides = cusped.of_circle(record.source) == no_id;
  return sum_of_sides(measure_side(balls, boundary, own, other, 2 * pi, none),
                      both_sides ? measure_side(balls, boundary, other, own, 2 * pi, none) : SaddleMeasure{},
                      boundary.component_origin(own));
}

}  // namespace hsp
