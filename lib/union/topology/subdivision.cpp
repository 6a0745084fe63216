// Finds subdivision vertices, and their order along the arcs and circles on which they lie.
//
// As an example two balls of radius 5 at 0 and (8,0,0), with a free circle of radius 3 around (4,0,0). The plane
// through both centres that contains the direction z is y = 0. It halves the circle:
//   subdivision vertices     (4,0,3) and (4,0,-3)
//   host edges               the halves between them, y > 0 and y < 0
// Cut arcs of both balls through the axis of the circle are in that plane, too, and end in these two points.
#include "topology/subdivision.hpp"

#include <initializer_list>

#include "sphere/great_circles.hpp"

namespace hsp {
namespace {

using exact::Plane;
using exact::Vector;

Plane complement(const Plane &plane) {
  return {{-plane.v.x, -plane.v.y, -plane.v.z}, -plane.h, plane.perturbed, plane.index};
}

// Parallel vertical planes.
bool are_parallel(const Plane &a, const Plane &b) {
  return a.v.x * b.v.y == a.v.y * b.v.x;
}
bool same_direction(const Plane &a, const Plane &b) {
  return dot(a.v, b.v) > 0;
}

// A host edge on its ball a.
struct HostCircle {
  exact::Sphere sphere;
  Plane circle;
  Plane reference;
};

// Tests points of a host edge against planes, with one filter for all planes concerned.
class HostPointTest {
 public:
  HostPointTest(const HostCircle &host, const Plane &plane, const Plane &other)
      : predicates_(host.sphere, length_squared(host, plane, other)), circle_(host.circle) {}

  bool inside(const Plane &Q, int sign, const Plane &R) const { return predicates_.inside(circle_, Q, sign, R) > 0; }

 private:
  static double length_squared(const HostCircle &host, const Plane &plane, const Plane &other) {
    double largest = static_cast<double>(host.sphere.W);
    for (const Vector *v : {&host.circle.v, &host.reference.v, &plane.v, &other.v}) {
      const double squared = static_cast<double>(dot(*v, *v));
      if (squared > largest) largest = squared;
    }
    return largest;
  }

  exact::Predicates predicates_;
  Plane circle_;
};

// A subdivision vertex. Its plane is oriented so that the start of the host edge, the exit of the reference plane, lies
// outside it.
struct BoundedPoint {
  Plane plane;
  int sign;
  bool leaves_host;  // the plane's other point with the circle is covered by the reference

  BoundedPoint(const HostPointTest &test, const Plane &reference, const Plane &own, int own_sign)
      : plane(own), sign(own_sign) {
    if (test.inside(reference, +1, plane)) {
      plane = complement(plane);
      sign = -sign;
    }
    leaves_host = test.inside(plane, -sign, reference);
  }
};

// Whether subdivision vertex X comes before subdivision vertex Y, of another plane, counter-clockwise from the exit of
// the reference. If the circle is cut open there, it is a line, and the part that a plane covers is an interval [l, r];
// X is l if its sign is negative, else r.
bool comes_before(const HostCircle &host, const HostPointTest &test, const BoundedPoint &X, const BoundedPoint &Y) {
  // The other end of X's interval lies in the reference: on the host the interval covers all points after X.
  if (X.leaves_host) return test.inside(Y.plane, Y.sign, X.plane);
  if (Y.leaves_host) return !test.inside(X.plane, X.sign, Y.plane);
  if (test.inside(Y.plane, Y.sign, X.plane)) return X.sign < 0;
  if (test.inside(X.plane, X.sign, Y.plane)) return Y.sign > 0;
  // Neither plane covers the other's point, so neither interval contains the other one: the order of the points is that
  // of the intervals, and that of their mid-points. The mid-point of the reference lies outside the host.
  return exact::counter_clockwise_before(host.circle.v, host.reference.v, X.plane.v, Y.plane.v);
}

}  // namespace

// The plane goes through the centre of `ball`: with y = 2 (x - c_origin) it is m.y >= 2 m.(c_ball - c_origin).
Plane plane_of_cut(const BallSet &balls, uint32_t origin, uint32_t ball, uint32_t cap) {
  Plane plane = meridian_through(balls.exact_difference(ball, cap));
  if (ball != origin) plane.h = 2 * dot(plane.v, balls.exact_difference(origin, ball));
  return plane;
}

HostBalls balls_of_host(const Boundary &boundary, uint32_t host) {
  if (Subdivision::is_half_circle(boundary, host)) {
    const CircleRecord &circle = boundary.circle(Subdivision::circle_of(boundary, host));
    return {circle.ball[0], circle.ball[1]};
  }
  return {boundary.half_edge(boundary.twin(host)).circle, boundary.half_edge(host).circle};
}

void Subdivision::carve(Workspace &workspace, uint32_t cut_arcs) {
  points_ = FixedVector<InnerPoint>(workspace.take<InnerPoint>(2 * static_cast<uint64_t>(cut_arcs)));
}

void Subdivision::insert(const BallSet &balls, const Boundary &boundary, Span<CutArc> arcs, Span<uint32_t> first,
                         Patience &patience) {
  first_ = first;
  const uint32_t hosts = half_circle(boundary, boundary.circle_count(), 0);
  for (uint32_t host = 0; host < hosts; ++host) first_[host] = no_id;
  points_.clear();
  first_inner_ = 2 * boundary.circle_count();
  for (CutArc &arc : arcs) {
    if (!patience.allows(5000)) return;
    for (uint32_t end = 0; end < 2; ++end) arc.ends[end] = insert_end(balls, boundary, arc, end);
  }
}

SubdivisionVertex Subdivision::point_of_circle(const Boundary &boundary, uint32_t k) {
  const CircleRecord &circle = boundary.circle(k / 2);
  return {half_circle(boundary, k / 2, 0), circle.ball[0], circle.ball[1], k % 2 == 0 ? -1 : +1};
}

CutArcEnd Subdivision::insert_end(const BallSet &balls, const Boundary &boundary, const CutArc &arc, uint32_t end) {
  // The point where the arc starts is, on the host's circle, the entry into the arc's plane; the point where it ends is
  // the exit. The other ball sees the circle the other way round.
  int sign = end == 0 ? -1 : +1;
  uint32_t side = 0;
  uint32_t host_id = 0;
  HostBalls pair{arc.ball, no_id};
  const bool on_circle = arc.end[end].is_circle();
  if (on_circle) {
    const ClosedHalfEdge closed = arc.end[end].closed_half_edge();
    side = closed.side();
    host_id = half_circle(boundary, closed.circle(), 0);
    pair = {boundary.circle(closed.circle()).ball[0], boundary.circle(closed.circle()).ball[1]};
  } else {
    const uint32_t half_edge = arc.end[end].half_edge();
    const uint32_t other = boundary.half_edge(half_edge).circle;
    side = other < arc.ball ? 1 : 0;
    host_id = side == 0 ? half_edge : boundary.twin(half_edge);
    pair = side == 0 ? HostBalls{arc.ball, other} : HostBalls{other, arc.ball};
  }
  if (side == 1) sign = -sign;
  const uint32_t circle = circle_of(boundary, host_id);
  const auto end_on_point_of_circle = [&](int point_sign) {
    return CutArcEnd(2 * circle + (point_sign > 0 ? 1U : 0U), side);
  };
  // A cut arc through the circle's own axis. Seen from b the plane of the halves is reversed.
  if (on_circle && arc.cap == (side == 0 ? pair.b : pair.a)) return end_on_point_of_circle(side == 0 ? sign : -sign);

  uint32_t *link = &first_[host_id];
  if (on_circle || *link != no_id) {
    HostCircle host;
    const exact::LatticeBall own = balls.ball(pair.a);
    host.sphere = exact::sphere_of(own);
    host.circle = exact::plane_of(own, balls.ball(pair.b));
    const Plane plane = plane_of_cut(balls, pair.a, arc.ball, arc.cap);
    if (on_circle) {
      const Plane halves = meridian_through(host.circle.v);
      if (are_parallel(plane, halves)) {  // both contain the direction z and the centre of a or b: the same plane
        return end_on_point_of_circle(same_direction(plane, halves) ? sign : -sign);
      }
      host.reference = halves;
      if (HostPointTest(host, plane, halves).inside(plane, sign, halves)) {
        host.reference = complement(halves);
        link = &first_[++host_id];
      }
    } else {
      const HalfEdge &walk = boundary.half_edge(host_id);
      host.reference = exact::plane_of(own, balls.ball(boundary.half_edge(walk.next).circle));
    }

    // The list is sorted in the direction of the loop of ball a, clockwise. It is short.
    for (; *link != no_id; link = &points_[*link - first_inner_].next) {
      SubdivisionVertex &point = points_[*link - first_inner_].vertex;
      const Plane other = plane_of_cut(balls, pair.a, point.ball, point.cap);
      const bool one_plane =
          are_parallel(plane, other) && dot(plane.v, balls.exact_difference(arc.ball, point.ball)) == 0;
      if (one_plane && point.sign == (same_direction(plane, other) ? sign : -sign)) {
        // The ball of lower rank defines the plane, so that the position does not depend on ids.
        if (balls.ranks_before(arc.ball, point.ball)) {
          point.ball = arc.ball;
          point.cap = arc.cap;
          point.sign = sign;
        }
        return {*link, side};
      }
      const HostPointTest test(host, plane, other);
      const BoundedPoint placed(test, host.reference, plane, sign);
      const BoundedPoint there(test, host.reference, other, point.sign);
      // If both are ends of one interval, the entry comes first.
      if (one_plane ? there.sign < 0 : comes_before(host, test, there, placed)) break;
    }
  }
  const uint32_t following = *link;
  *link = size();
  points_.push({{host_id, arc.ball, arc.cap, sign}, following});
  return {size() - 1, side};
}

}  // namespace hsp
