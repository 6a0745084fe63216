#include "measure/areas.hpp"

#include "exact/filter.hpp"
#include "measure/arc_angles.hpp"

namespace hsp {
namespace {

using exact::DoubleVector;

// The centre of circle P relative to the ball's centre: h v / (2 |v|^2).
DoubleVector circle_centre(const exact::Plane &P) {
  const double along = static_cast<double>(P.h) / (2 * static_cast<double>(exact::dot(P.v, P.v)));
  const DoubleVector v = exact::to_double(P.v);
  return {v.x * along, v.y * along, v.z * along};
}

// Circle P of a sphere of radius r in its own terms.
struct CircleGeometry {
  DoubleVector axis;      // unit vector v / |v|
  double radius_squared;  // Delta / (4 |v|^2)
  double cap_cosine;      // h / (2 r |v|)

  CircleGeometry(const exact::Sphere &sphere, double radius, const exact::Plane &P) {
    const double U = static_cast<double>(exact::dot(P.v, P.v));
    const double distance = std::sqrt(U);
    const double h = static_cast<double>(P.h);
    const DoubleVector v = exact::to_double(P.v);
    axis = {v.x / distance, v.y / distance, v.z / distance};
    const double Delta = exact::Exact::circle_discriminant(sphere, P);
    radius_squared = Delta > 0.0 ? Delta / (4 * U) : 0.0;
    cap_cosine = radius > 0.0 ? h / (2 * radius * distance) : 0.0;
  }
};

// Sums the terms of
//   area / r^2 = 2 pi (2 #faces - #loops) + sum over arcs of cos(cap) * angle - sum over vertices of the exterior angle
//   N = -1/2 sum over arcs from p to q, counter-clockwise, of [ m x (q - p) + rho^2 angle u ]
// (Gauss-Bonnet; vector area by Stokes). The part m x (q - p) is gathered per vertex: it ends one arc and starts
// another.
struct Sums {
  double cosines = 0.0;
  double exteriors = 0.0;
  DoubleVector vector_area{0.0, 0.0, 0.0};

  void add_arc(const CircleGeometry &circle, double angle) {
    cosines += circle.cap_cosine * angle;
    const double weight = -0.5 * circle.radius_squared * angle;
    vector_area = exact::combine(1.0, vector_area, weight, circle.axis);
  }
  // Counter-clockwise, the arc on the circle `out` ends here and the one on `in` starts.
  void add_vertex(const exact::Plane &out, const exact::Plane &in, const DoubleVector &offset, double exterior) {
    exteriors += exterior;
    const DoubleVector difference = exact::combine(1.0, circle_centre(out), -1.0, circle_centre(in));
    vector_area = exact::combine(1.0, vector_area, -0.5, exact::cross(difference, offset));
  }
};

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
  const CircleGeometry circle(exact::sphere_of(own), balls.r[first], P);
  const DoubleVector centre = circle_centre(P);
  return {
      {centre.x, centre.y, centre.z}, {circle.axis.x, circle.axis.y, circle.axis.z}, std::sqrt(circle.radius_squared)};
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
  const uint32_t loops = boundary.first_loop[i + 1] - boundary.first_loop[i];
  const exact::LatticeBall own = balls.ball(i);
  const exact::Sphere sphere = exact::sphere_of(own);
  const double radius = balls.r[i];
  const auto plane = [&](uint32_t j) { return exact::plane_of(own, balls.ball(j)); };

  Sums sums;
  for (uint32_t u = boundary.first_use[i]; u < boundary.first_use[i + 1]; ++u) {
    const VertexUse &use = boundary.uses[u];
    const VertexUse &end = boundary.uses[use.next];
    const exact::Plane P = plane(use.out);
    const exact::Plane R = plane(use.in);
    const exact::Plane Q = plane(end.out);
    const double root_D = boundary.root_discriminant[use.vertex];
    sums.add_arc(CircleGeometry(sphere, radius, P),
                 FreeArc(P, Q, boundary.root_discriminant[end.vertex], R, root_D).angle());
    // The loop leaves along P at the entry into ball R: the point p- of P and R.
    double offset[3];
    vertex_offset(P, R, -1, root_D, offset);
    sums.add_vertex(P, R, {offset[0], offset[1], offset[2]}, exterior_angle(root_D, sphere, P, R));
  }
  for (uint32_t s = boundary.first_circle_side[i]; s < boundary.first_circle_side[i + 1]; ++s) {
    const uint32_t side = boundary.circle_side[s] % 2;
    const CircleRecord &circle = boundary.circles[boundary.circle_side[s] / 2];
    sums.add_arc(CircleGeometry(sphere, radius, plane(circle.ball[1 - side])), 2 * pi);
  }

  const double characteristic = 2.0 * static_cast<double>(faces) - static_cast<double>(loops);
  const double steradians = 2 * pi * characteristic + sums.cosines - sums.exteriors;
  BallMeasure measure;
  // A face can be infinitesimal: its area is 0 up to rounding, on either side.
  measure.area = steradians > 0.0 ? radius * radius * steradians : 0.0;
  // The origin of the component is its ball of lowest rank, so that the terms do not grow with the distance to other
  // components.
  const exact::LatticeBall origin = balls.ball(boundary.components.root(i));
  const DoubleVector arm = exact::to_double(
      exact::Vector{own.centre.x - origin.centre.x, own.centre.y - origin.centre.y, own.centre.z - origin.centre.z});
  measure.volume = (radius * measure.area + exact::dot(arm, sums.vector_area)) / 3;
  return measure;
}

}  // namespace hsp
