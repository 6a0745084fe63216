#include "topology/subdivision.hpp"

#include <initializer_list>

#include "boundary/half_edge_links.hpp"
#include "sphere/great_circles.hpp"

namespace hsp {
namespace {

using exact::Plane;
using exact::Vector;

Vector difference(const BallSet &balls, uint32_t from, uint32_t to) {
  const Vector a = balls.ball(from).centre;
  const Vector b = balls.ball(to).centre;
  return {b.x - a.x, b.y - a.y, b.z - a.z};
}

Plane complement(const Plane &plane) {
  return {{-plane.v.x, -plane.v.y, -plane.v.z}, -plane.h, plane.tau, plane.index};
}

// Parallel vertical planes.
bool are_parallel(const Plane &a, const Plane &b) {
  return a.v.x * b.v.y == a.v.y * b.v.x;
}
bool same_direction(const Plane &a, const Plane &b) {
  return exact::dot(a.v, b.v) > 0;
}

// A carrier as seen from its ball a.
struct Carrier {
  exact::Sphere sphere;
  Plane circle;
  Plane anchor;
};

// Questions about points of a carrier and two of the planes through them, for the filter of one set of planes.
class PointTest {
 public:
  PointTest(const Carrier &carrier, const Plane &plane, const Plane &other)
      : predicates_(carrier.sphere, length_squared(carrier, plane, other)), circle_(carrier.circle) {}

  bool inside(const Plane &Q, int sign, const Plane &R) const { return predicates_.inside(circle_, Q, sign, R) > 0; }

 private:
  static double length_squared(const Carrier &carrier, const Plane &plane, const Plane &other) {
    double largest = static_cast<double>(carrier.sphere.W);
    for (const Vector *v : {&carrier.circle.v, &carrier.anchor.v, &plane.v, &other.v}) {
      const double squared = static_cast<double>(exact::dot(*v, *v));
      if (squared > largest) largest = squared;
    }
    return largest;
  }

  exact::Predicates predicates_;
  Plane circle_;
};

// A split point, its plane turned so that the carrier's start, the exit of the anchor, lies outside.
struct PlacedPoint {
  Plane plane;
  int sign;
  bool leaves_carrier;  // the plane's other point with the circle is covered by the anchor

  PlacedPoint(const PointTest &test, const Plane &anchor, const Plane &own, int own_sign) : plane(own), sign(own_sign) {
    if (test.inside(anchor, +1, plane)) {
      plane = complement(plane);
      sign = -sign;
    }
    leaves_carrier = test.inside(plane, -sign, anchor);
  }
};

// Whether split point X comes before Y, of another plane, counter-clockwise from the exit of the anchor. Cut open
// there, the circle is a line and what a plane covers is an interval [l, r] of it; X is l if its sign is negative.
bool comes_before(const Carrier &carrier, const PointTest &test, const PlacedPoint &X, const PlacedPoint &Y) {
  // The other end of X's interval lies in the anchor: on the carrier it covers all after X.
  if (X.leaves_carrier) return test.inside(Y.plane, Y.sign, X.plane);
  if (Y.leaves_carrier) return !test.inside(X.plane, X.sign, Y.plane);
  if (test.inside(Y.plane, Y.sign, X.plane)) return X.sign < 0;
  if (test.inside(X.plane, X.sign, Y.plane)) return Y.sign > 0;
  // Neither covers the other's point, so neither interval holds the other one: they and their mid-points are ordered as
  // the points are. The anchor's own mid-point lies outside the carrier.
  return exact::counter_clockwise_before(carrier.circle.v, carrier.anchor.v, X.plane.v, Y.plane.v);
}

}  // namespace

// It goes through the centre of `ball`, so that with y = 2 (x - c_origin) it is m.y >= 2 m.(c_ball - c_origin).
Plane plane_of_cut(const BallSet &balls, uint32_t origin, uint32_t ball, uint32_t cap) {
  Plane plane = meridian_through(difference(balls, ball, cap));
  if (ball != origin) plane.h = 2 * exact::dot(plane.v, difference(balls, origin, ball));
  return plane;
}

CarrierBalls balls_of_carrier(const BoundaryStructure &boundary, uint32_t carrier) {
  const uint32_t first_half = SplitPoints::half_circle(boundary, 0, 0);
  if (carrier >= first_half) {
    const CircleRecord &circle = boundary.circles[(carrier - first_half) / 2];
    return {circle.ball[0], circle.ball[1]};
  }
  return {boundary.uses[twin_use(boundary, carrier)].out, boundary.uses[carrier].out};
}

void SplitPoints::carve(Workspace &workspace, uint32_t edges, uint32_t extra_arcs) {
  // Arcs have two uses and are an edge each, free circles two halves and at least two edges.
  first_ = workspace.take<uint32_t>(2 * static_cast<uint64_t>(edges));
  points_ = FixedVector<SplitPoint>(workspace.take<SplitPoint>(edges + 2 * static_cast<uint64_t>(extra_arcs)));
}

void SplitPoints::insert(const BallSet &balls, const BoundaryStructure &boundary, Span<ExtraArc> arcs) {
  const uint32_t carriers = half_circle(boundary, boundary.circles.size(), 0);
  for (uint32_t carrier = 0; carrier < carriers; ++carrier) first_[carrier] = no_id;
  points_.clear();
  for (uint32_t c = 0; c < boundary.circles.size(); ++c) {
    const CircleRecord &circle = boundary.circles[c];
    const uint32_t carrier = half_circle(boundary, c, 0);
    points_.push({carrier, circle.ball[0], circle.ball[1], -1, {no_id, no_id}, no_id});
    points_.push({carrier, circle.ball[0], circle.ball[1], +1, {no_id, no_id}, no_id});
  }
  for (uint32_t k = 0; k < arcs.size(); ++k) {
    for (uint32_t end = 0; end < 2; ++end) arcs[k].split[end] = insert_end(balls, boundary, arcs[k], k, end);
  }
}

uint32_t SplitPoints::insert_end(const BallSet &balls, const BoundaryStructure &boundary, const ExtraArc &arc,
                                 uint32_t arc_id, uint32_t end) {
  // The arc leaves the circle it starts on: as that circle sees it, in the entry into the arc's plane; it ends in an
  // exit. The other ball sees the circle the other way round.
  int sign = end == 0 ? -1 : +1;
  uint32_t side = 0;
  uint32_t carrier_id = 0;
  CarrierBalls pair{arc.ball, no_id};
  const bool on_circle = (arc.end[end] & ExtraArc::circle_bit) != 0;
  if (on_circle) {
    const uint32_t circle_side = arc.end[end] & ~ExtraArc::circle_bit;
    side = circle_side % 2;
    carrier_id = half_circle(boundary, circle_side / 2, 0);
    pair = {boundary.circles[circle_side / 2].ball[0], boundary.circles[circle_side / 2].ball[1]};
  } else {
    const uint32_t other = boundary.uses[arc.end[end]].out;
    side = other < arc.ball ? 1 : 0;
    carrier_id = side == 0 ? arc.end[end] : twin_use(boundary, arc.end[end]);
    pair = side == 0 ? CarrierBalls{arc.ball, other} : CarrierBalls{other, arc.ball};
  }
  if (side == 1) sign = -sign;
  const uint32_t reference = 2 * arc_id + end;
  const uint32_t circle = (carrier_id - half_circle(boundary, 0, 0)) / 2;
  const auto end_on_point_of_circle = [&](int point_sign) {
    const uint32_t split = 2 * circle + (point_sign > 0 ? 1 : 0);
    points_[split].extra[side] = reference;
    return split;
  };
  // An extra arc through the circle's own axis; seen from b the plane of the halves is turned round.
  if (on_circle && arc.cap == (side == 0 ? pair.b : pair.a)) return end_on_point_of_circle(side == 0 ? sign : -sign);

  uint32_t *link = &first_[carrier_id];
  if (on_circle || *link != no_id) {
    Carrier carrier;
    const exact::LatticeBall own = balls.ball(pair.a);
    carrier.sphere = exact::sphere_of(own);
    carrier.circle = exact::plane_of(own, balls.ball(pair.b));
    const Plane plane = plane_of_cut(balls, pair.a, arc.ball, arc.cap);
    if (on_circle) {
      const Plane halves = meridian_through(carrier.circle.v);
      if (are_parallel(plane, halves)) {  // both contain the direction z and the centre of a or b: the same plane
        return end_on_point_of_circle(same_direction(plane, halves) ? sign : -sign);
      }
      carrier.anchor = halves;
      if (PointTest(carrier, plane, halves).inside(plane, sign, halves)) {
        carrier.anchor = complement(halves);
        link = &first_[++carrier_id];
      }
    } else {
      const VertexUse &walk = boundary.uses[carrier_id];
      carrier.anchor = exact::plane_of(own, balls.ball(boundary.uses[walk.next].out));
    }

    // The list is sorted as the loop of ball a walks it, clockwise. The points of one list are few.
    for (; *link != no_id; link = &points_[*link].next) {
      SplitPoint &point = points_[*link];
      const Plane other = plane_of_cut(balls, pair.a, point.ball, point.cap);
      const bool one_plane =
          are_parallel(plane, other) && exact::dot(plane.v, difference(balls, arc.ball, point.ball)) == 0;
      if (one_plane && point.sign == (same_direction(plane, other) ? sign : -sign)) {
        point.extra[side] = reference;
        // The plane is told by the ball of lower rank, so that the position does not depend on ids.
        if (exact::ranks_before(balls.ball(arc.ball), balls.ball(point.ball))) {
          point.ball = arc.ball;
          point.cap = arc.cap;
          point.sign = sign;
        }
        return *link;
      }
      const PointTest test(carrier, plane, other);
      const PlacedPoint placed(test, carrier.anchor, plane, sign);
      const PlacedPoint there(test, carrier.anchor, other, point.sign);
      // Of two ends of one interval the entry comes first.
      if (one_plane ? there.sign < 0 : comes_before(carrier, test, there, placed)) break;
    }
  }
  const uint32_t following = *link;
  *link = points_.size();
  SplitPoint point{carrier_id, arc.ball, arc.cap, sign, {no_id, no_id}, following};
  point.extra[side] = reference;
  points_.push(point);
  return points_.size() - 1;
}

}  // namespace hsp
