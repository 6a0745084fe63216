#include "boundary/point_location.hpp"

#include "core/first_index.hpp"
#include "core/small_code.hpp"

namespace hsp {

using exact::Plane;

namespace {

// With so many circles, or half-edges, a binary search finds the first of a neighbour: both are in the order of the
// ranks of their neighbours.
constexpr uint32_t many = 32;

// The free circle, or the first arc, of ball i that lies on the sphere of `neighbour`.
[[gnu::always_inline]] inline LoopElement first_element_at(const BallSet &balls, const Boundary &boundary, uint32_t i,
                                                           uint32_t neighbour) {
  const Span<const ClosedHalfEdge> circles = boundary.circles(i);
  uint32_t circle = 0, end = circles.size();
  if (!small_code && end >= many) {
    circle = first_index(0, end - 1,
                         [&](uint32_t k) { return !balls.ranks_before(boundary.neighbour(circles[k]), neighbour); });
    end = circle + 1;
  }
  for (; circle < end; ++circle) {
    if (boundary.neighbour(circles[circle]) == neighbour) return LoopElement::circle(circles[circle]);
  }
  const IdRange all = boundary.half_edges(i);
  uint32_t first = all.first;
  if (!small_code && all.size() >= many) {
    first = first_index(first, all.last,
                        [&](uint32_t e) { return !balls.ranks_before(boundary.half_edge(e).circle, neighbour); });
  }
  while (boundary.half_edge(first).circle != neighbour) ++first;
  return LoopElement::arc(first);
}

// The element that contains a free point: `found`, which is the first one on its circle, or a later one on the same
// circle. plane_of(j) is the plane of ball j as seen from ball i.
template <class PlaneOf>
[[gnu::always_inline]] inline LoopElement element_from(LoopElement found, const Boundary &boundary,
                                                       const exact::Predicates &predicates, uint32_t i,
                                                       PlaneOf plane_of, const Plane &other, int sign) {
  if (found.is_circle()) return found;
  const uint32_t first = found.half_edge(), end = boundary.half_edges(i).last;
  const uint32_t neighbour = boundary.half_edge(first).circle;
  uint32_t last = first + 1;
  while (last < end && boundary.half_edge(last).circle == neighbour) ++last;
  if (last - first == 1) return found;
  const auto arc = [&](uint32_t k, Plane &leave, Plane &entry) {
    const HalfEdge &half_edge = boundary.half_edge(first + k);
    leave = plane_of(boundary.half_edge(half_edge.next).circle);
    entry = plane_of(boundary.previous_circle(i, half_edge));
  };
  return LoopElement::arc(first +
                          interval_that_contains(predicates, plane_of(neighbour), last - first, arc, other, -sign));
}

template <class PlaneOf>
LoopElement element_at(const BallSet &balls, const Boundary &boundary, const exact::Predicates &predicates, uint32_t i,
                       uint32_t neighbour, PlaneOf plane_of, const Plane &other, int sign) {
  return element_from(first_element_at(balls, boundary, i, neighbour), boundary, predicates, i, plane_of, other, sign);
}

// One ball with several faces, and the caps that keep its faces apart: those with arcs on their circles. Of the other
// caps, some have no free point on their circles, so that no face ends there. The rest have free circles: they are
// discs within one face, and a walk across such a disc comes out in the face where it went in.
class SeveralFaces {
 public:
  SeveralFaces(const BallSet &balls, const Boundary &boundary, uint32_t i)
      : balls_(balls), boundary_(boundary), i_(i), own_(balls.ball(i)) {}

  const exact::LatticeBall &own() const { return own_; }
  Plane plane(uint32_t neighbour) const { return exact::plane_of(own_, balls_.ball(neighbour)); }

  // Calls visit(neighbour) for every ball with such a cap.
  template <class Visit>
  void visit_neighbours(Visit visit) const {
    uint32_t last = no_id;
    for (const uint32_t e : boundary_.half_edges(i_)) {
      const uint32_t neighbour = boundary_.half_edge(e).circle;
      if (neighbour != last) visit(neighbour);
      last = neighbour;
    }
  }

  exact::Predicates predicates() const {
    const exact::Sphere sphere = exact::sphere_of(own_);
    double length_squared = static_cast<double>(sphere.W);
    visit_neighbours([&](uint32_t neighbour) {
      const exact::Vector v = plane(neighbour).v;
      const double U = static_cast<double>(dot(v, v));
      if (U > length_squared) length_squared = U;
    });
    return {sphere, length_squared};
  }

  // The face that contains a free point of a great circle; no_id if no such cap crosses the circle. Clockwise from the
  // point, the first cap is met at its exit, on a loop of the point's face. lies_between(leave, entry) says whether the
  // point lies on the way from the exit of one cap to the entry of another; only caps that are apart on the circle are
  // asked about.
  template <class LiesBetween>
  uint32_t face_of_point(const exact::Predicates &predicates, const Plane &circle, LiesBetween lies_between) const {
    uint32_t nearest = no_id;
    Plane nearest_plane{};
    visit_neighbours([&](uint32_t neighbour) {
      const Plane cap = plane(neighbour);
      if (predicates.crossing(circle, cap).sign < 0) return;
      if (nearest != no_id && predicates.inside(circle, nearest_plane, +1, cap) < 0 &&
          (predicates.inside(circle, cap, +1, nearest_plane) > 0 || lies_between(nearest_plane, cap))) {
        return;
      }
      nearest = neighbour;
      nearest_plane = cap;
    });
    if (nearest == no_id) return no_id;
    const auto plane_of = [this](uint32_t neighbour) { return plane(neighbour); };
    return boundary_.face_of(element_at(balls_, boundary_, predicates, i_, nearest, plane_of, circle, +1));
  }

  // The face of the highest (pole = +1) or lowest (-1) point. The great circle through the pole and the axis of a cap
  // crosses this cap, so that a face is found.
  uint32_t face_of_pole(const exact::Predicates &predicates, int pole) const {
    const Plane meridian = meridian_through(plane(boundary_.half_edge(boundary_.half_edges(i_).first).circle).v);
    return face_of_point(predicates, meridian, [&](const Plane &leave, const Plane &entry) {
      return pole_lies_between(meridian.v, leave.v, entry.v, pole);
    });
  }

 private:
  const BallSet &balls_;
  const Boundary &boundary_;
  uint32_t i_;
  exact::LatticeBall own_;
};

}  // namespace

LoopElement locate_on_boundary(const Caps &caps, const exact::Predicates &predicates, const Boundary &boundary,
                               uint32_t cap, const Plane &other, int sign) {
  const LoopElement first = first_element_at(caps.balls(), boundary, caps.origin, caps.ball[cap]);
  return locate_from_first(caps, predicates, boundary, first, other, sign);
}

void find_first_elements(const Caps &caps, const Boundary &boundary, Span<uint32_t> of_caps) {
  for (uint32_t &of_cap : of_caps) of_cap = no_id;
  if (of_caps.empty()) return;
  for (const ClosedHalfEdge e : boundary.circles(caps.origin)) {
    of_caps[caps.cap_of(boundary.neighbour(e))] = LoopElement::circle(e).code();
  }
  uint32_t before = no_id;
  for (const uint32_t e : boundary.half_edges(caps.origin)) {
    const uint32_t circle = boundary.half_edge(e).circle;
    if (circle != before) of_caps[caps.cap_of(circle)] = LoopElement::arc(e).code();
    before = circle;
  }
}

LoopElement locate_from_first(const Caps &caps, const exact::Predicates &predicates, const Boundary &boundary,
                              LoopElement first, const Plane &other, int sign) {
  const auto plane_of = [&caps](uint32_t neighbour) { return caps.plane_of_ball(neighbour); };
  return element_from(first, boundary, predicates, caps.origin, plane_of, other, sign);
}

uint32_t face_of_top(const BallSet &balls, const Boundary &boundary, uint32_t i) {
  if (boundary.faces(i).size() == 1) return boundary.faces(i).first;
  const SeveralFaces ball(balls, boundary, i);
  return ball.face_of_pole(ball.predicates(), +1);
}

uint32_t face_of_entry(const BallSet &balls, const Boundary &boundary, uint32_t i, int64_t x, int64_t y) {
  if (boundary.faces(i).size() == 1) return boundary.faces(i).first;
  const SeveralFaces ball(balls, boundary, i);
  const exact::Predicates predicates = ball.predicates();
  const int64_t dx = x - ball.own().centre.x;
  const int64_t dy = y - ball.own().centre.y;
  if (dx == 0 && dy == 0) return ball.face_of_pole(predicates, -1);
  // The point is p+ of the great circle through it and the poles, and of the vertical plane across that circle.
  const Plane meridian = exact::virtual_plane({-dy, dx, 0}, 0);
  const Plane across = exact::virtual_plane({dx, dy, 0}, 2 * (dx * dx + dy * dy));
  const uint32_t face = ball.face_of_point(predicates, meridian, [&](const Plane &leave, const Plane &entry) {
    const auto caps_apart = [&](uint32_t k, Plane &from, Plane &to) {
      from = k == 0 ? leave : entry;
      to = k == 0 ? entry : leave;
    };
    return interval_that_contains(predicates, meridian, 2, caps_apart, across, +1) == 0;
  });
  // If no such cap crosses the great circle, it lies in one face, apart from discs within the face. So the face is that
  // of the pole.
  return face != no_id ? face : ball.face_of_pole(predicates, -1);
}

}  // namespace hsp
