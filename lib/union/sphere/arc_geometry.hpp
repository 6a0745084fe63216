// Positions and angles on one sphere: crossing points of circles, the centre and radius of a circle, the angles of arcs
// and at vertices. Lengths are in lattice steps, positions are relative to the centre of the ball, angles in radians.
#pragma once

#include "core/elementary.hpp"
#include "exact/circle_crossing.hpp"
#include "exact/predicates.hpp"
#include "model/ball_set.hpp"

namespace hsp {

// The circle in which the sphere of `own` meets that of another ball.
struct CircleGeometry {
  Vec3 axis;  // a unit vector towards the other ball
  Vec3 centre;
  double height;  // of the circle's plane along the axis
  double radius;

  // P: the plane of the other ball. The centre is h v / (2 |v|^2), the radius sqrt(Delta) / (2 |v|). Inline, as most
  // callers read only some of the members.
  CircleGeometry(const exact::Sphere &sphere, const exact::Plane &P) {
    const double U = static_cast<double>(dot(P.v, P.v));
    const double distance = std::sqrt(U);
    const Vec3 v = exact::to_double(P.v);
    axis = {v.x / distance, v.y / distance, v.z / distance};
    const double along = static_cast<double>(P.h) / (2 * U);
    centre = {v.x * along, v.y * along, v.z * along};
    height = static_cast<double>(P.h) / (2 * distance);
    const double Delta = exact::Exact::circle_discriminant(sphere, P);
    radius = Delta > 0.0 ? std::sqrt(Delta / (4 * U)) : 0.0;
  }
  CircleGeometry(const BallSet &balls, uint32_t own, uint32_t other);
};

// The common point p+ (sign > 0) or p- of the circles of P and Q. root_D: sqrt(D), from exact::discriminant().
Vec3 crossing_point(const exact::Plane &P, const exact::Plane &Q, int sign, double root_D);

// The same for many points of one sphere: in doubles where these are precise enough, else from the exact integers.
class CrossingPointFinder {
 public:
  struct Point {
    double root_D;
    Vec3 position;
  };

  // length_squared: as for exact::Predicates.
  CrossingPointFinder(const exact::Sphere &sphere, double length_squared);
  // The point p+ of the circles of P and Q, which cross.
  Point find(const exact::Plane &P, const exact::Plane &Q) const {
    const CircleCrossing<Vec3, double> crossing = exact::circle_crossing(P, Q);
    const double D = crossing.discriminant(static_cast<double>(sphere_.W));
    if (D <= well_conditioned_) return find_exactly(P, Q);
    const double root_D = std::sqrt(D);
    return {root_D, crossing.point(root_D, 0.5)};
  }

 private:
  Point find_exactly(const exact::Plane &P, const exact::Plane &Q) const;

  exact::Sphere sphere_;
  double well_conditioned_;  // a discriminant above this has a relative error below 2^-40
};

// The angle by which a loop turns at a vertex of circles P and Q, in [0, pi].
double exterior_angle(double root_D, const exact::Sphere &sphere, const exact::Plane &P, const exact::Plane &Q);

// The angle of the free arc of circle P from the exit of ball Q to the entry of ball R, in [0, 2 pi], from exact
// integers rounded once.
double arc_angle(const exact::Plane &P, const exact::Plane &Q, double root_D_exit, const exact::Plane &R,
                 double root_D_entry);

// The counter-clockwise angle about an axis from one vector to another, in [0, 2 pi]. Both are perpendicular to the
// axis; lengths do not matter.
double turn_about(const Vec3 &axis, const Vec3 &from, const Vec3 &to);

}  // namespace hsp
