#include "measure/boundary_metric_check.hpp"

#include <initializer_list>

#include "exact/filter.hpp"
#include "measure/areas.hpp"
#include "measure/boundary_positions.hpp"
#include "sphere/arc_geometry.hpp"

namespace hsp {
namespace {

double norm(const Vec3 &a) {
  return std::sqrt(dot(a, a));
}

// A circle on a ball, in doubles, relative to the ball's centre.
struct CheckCircle {
  Vec3 axis, centre;
  double radius;
  double cosine;  // of the cap's angle

  CheckCircle(const BallSet &balls, uint32_t ball, uint32_t other) {
    const CircleGeometry circle(balls, ball, other);
    axis = circle.axis;
    centre = circle.centre;
    radius = circle.radius;
    cosine = balls.r[ball] > 0.0 ? dot(axis, centre) / balls.r[ball] : 0.0;
  }
};

// The result of the second way for one ball, and a bound of its rounding error.
struct SecondMeasure {
  double steradians = 0.0;
  Vec3 vector_area{0.0, 0.0, 0.0};
  double error_bound = 0.0;  // of steradians, and of the vector area in units of r^2
};

class BoundaryMetricCheck {
 public:
  BoundaryMetricCheck(const BallSet &balls, const Boundary &boundary) : balls_(balls), boundary_(boundary) {}

  BoundaryViolation run() const {
    double volume = 0.0;
    double second_volume = 0.0;
    double scale = 0.0;
    for (uint32_t i = 0; i < balls_.n; ++i) {
      if (!boundary_.is_exposed(i)) continue;
      for (const uint32_t u : boundary_.half_edges(i)) {
        if (!lies_on_its_spheres(i, u)) return {BoundaryInvariant::positions, boundary_.half_edge(u).vertex};
      }
      const double r = balls_.r[i];
      const BallMeasure first = measure_ball(balls_, boundary_, i);
      const SecondMeasure second = measure_again(i);
      const double difference = first.area - r * r * second.steradians;
      const double error_bound = r * r * second.error_bound;
      // No area is negative (FreeSurface). Written so that a value that is not a number fails.
      const bool on_the_sphere = first.area <= 4 * pi * r * r + error_bound;
      if (!on_the_sphere || !(std::fabs(difference) <= error_bound)) return {BoundaryInvariant::areas, i};
      volume += first.volume;
      // Another origin: the centre of the component's first ball, moved by that ball's own radius along each axis.
      const double shift = balls_.r[boundary_.component_origin(i)];
      const Vec3 arm = offset_from_origin(balls_, boundary_, i) - Vec3{shift, shift, shift};
      second_volume += (r * r * r * second.steradians + dot(arm, second.vector_area)) / 3;
      scale += r * r * second.error_bound * (r + norm(arm));
    }
    const double difference = volume - second_volume;
    return std::fabs(difference) <= scale ? BoundaryViolation{} : BoundaryViolation{BoundaryInvariant::closure, 0};
  }

 private:
  bool lies_on_its_spheres(uint32_t ball, uint32_t u) const {
    const HalfEdge &half_edge = boundary_.half_edge(u);
    const Vec3 x = start_of(balls_, boundary_, ball, half_edge);
    const double r = balls_.r[ball];
    constexpr double tolerance = 0x1p-40;
    double error = norm(x) - r;
    double largest = r;
    for (const uint32_t other : {boundary_.previous_circle(ball, half_edge), half_edge.circle}) {
      const double off = norm(x - balls_.difference(ball, other)) - balls_.r[other];
      if (off * off > error * error) error = off;
      if (balls_.r[other] > largest) largest = balls_.r[other];
    }
    return error * error <= tolerance * tolerance * largest * largest;
  }

  // Gauss-Bonnet, with angles between radii of circles and between tangents, all from positions. The vector area is
  // half the integral of x cross dx along the arcs: for each arc a triangle from the centre, and the segment between
  // the chord and the arc.
  SecondMeasure measure_again(uint32_t i) const {
    const double r = balls_.r[i];
    const uint32_t loops = boundary_.loops(i).size();
    const uint32_t faces = boundary_.faces(i).size();
    SecondMeasure sum;
    sum.steradians = 2 * pi * (2.0 * faces - 1.0 * loops);
    sum.error_bound = 0x1p-44;
    for (const uint32_t u : boundary_.half_edges(i)) {
      const HalfEdge &half_edge = boundary_.half_edge(u);
      const HalfEdge &end = boundary_.half_edge(half_edge.next);
      const CheckCircle out(balls_, i, half_edge.circle);
      const CheckCircle in(balls_, i, boundary_.previous_circle(i, half_edge));
      // The loop runs from q to p, the arc runs counter-clockwise from p to q.
      const Vec3 q = start_of(balls_, boundary_, i, half_edge);
      const Vec3 p = start_of(balls_, boundary_, i, end);
      const Vec3 to_q = q - out.centre;
      const Vec3 to_p = p - out.centre;
      const double sine = dot(out.axis, cross(to_p, to_q));
      double angle = arc_tangent(sine, dot(to_p, to_q));
      if (angle < 0.0) angle += 2 * pi;
      // If rounding cannot distinguish a full turn from none, the angle from exact integers does.
      constexpr double unclear = 0x1p-16;
      const double known = angle_of(balls_, boundary_, i, u);
      if (angle < unclear || angle > 2 * pi - unclear) angle = known;
      // The loop arrives along circle `in` and leaves along circle `out`, clockwise about both axes.
      const Vec3 arriving = cross(q, in.axis);
      const Vec3 leaving = cross(q, out.axis);
      const double turn = arc_tangent(norm(cross(arriving, leaving)), dot(arriving, leaving));
      sum.steradians += out.cosine * angle - turn;
      const Vec3 chord = cross(p, q);
      const double segment = out.radius * out.radius * angle - sine;
      // The face lies to the other side of the arc, hence the sign.
      sum.vector_area = combine(1.0, sum.vector_area, -0.5, combine(1.0, chord, segment, out.axis));
      sum.error_bound += error_bound_of(r, out.radius) + error_bound_of(r, in.radius);
    }
    for (const ClosedHalfEdge closed : boundary_.circles(i)) {
      const CheckCircle circle(balls_, i, boundary_.neighbour(closed));
      sum.steradians += 2 * pi * circle.cosine;
      sum.vector_area = combine(1.0, sum.vector_area, -pi * circle.radius * circle.radius, circle.axis);
      sum.error_bound += 0x1p-44;
    }
    return sum;
  }

  // The error bound of an angle: a position has an error of some units of r, and this is a wider angle on a smaller
  // circle. A bound beyond some turns carries no information.
  static double error_bound_of(double r, double circle_radius) {
    const double error_bound = circle_radius > 0.0 ? 0x1p-44 * r / circle_radius : 8 * pi;
    return error_bound < 8 * pi ? error_bound : 8 * pi;
  }

  const BallSet &balls_;
  const Boundary &boundary_;
};

}  // namespace

BoundaryViolation check_boundary_metric(const BallSet &balls, const Boundary &boundary) {
  return BoundaryMetricCheck(balls, boundary).run();
}

}  // namespace hsp
