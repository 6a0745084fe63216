#include "boundary/point_location.hpp"

namespace hsp {

using exact::Plane;

LoopElement locate_on_boundary(const Caps &caps, const exact::Predicates &predicates, const Boundary &boundary,
                               uint32_t cap, const Plane &other, int sign) {
  const uint32_t neighbour = caps.ball[cap];
  for (const ClosedHalfEdge e : boundary.circles(caps.origin)) {
    if (boundary.neighbour(e) == neighbour) return LoopElement::circle(e);
  }
  // Half-edges are sorted by their circles, so the arcs of one circle are consecutive.
  const IdRange all = boundary.half_edges(caps.origin);
  uint32_t first = all.first;
  while (boundary.half_edge(first).circle != neighbour) ++first;
  uint32_t last = first + 1;
  while (last < all.last && boundary.half_edge(last).circle == neighbour) ++last;
  const auto arc = [&](uint32_t k, Plane &leave, Plane &entry) {
    const HalfEdge &half_edge = boundary.half_edge(first + k);
    leave = caps.plane[caps.cap_of(boundary.half_edge(half_edge.next).circle)];
    entry = caps.plane[caps.cap_of(half_edge.previous_circle)];
  };
  return LoopElement::arc(first + interval_that_contains(predicates, caps.plane[cap], last - first, arc, other, -sign));
}

namespace {

// A great circle through the pole and the axis of a cap is covered there, so that its free interval around the pole has
// ends, which lie on loops of the face.
uint32_t face_of_pole(const Boundary &boundary, GatheredBall &gathered, int pole) {
  Caps &caps = gathered.caps;
  const exact::Predicates predicates = caps.predicates();
  const Plane meridian = meridian_through(caps.plane[0].v);
  gathered.intervals.find(caps, predicates, meridian);
  uint32_t face = boundary.faces(caps.origin).first;
  gathered.intervals.visit([&](const FreeInterval &interval) {
    if (!contains_pole(caps, predicates, meridian, interval, pole)) return;
    face = boundary.face_of(locate_on_boundary(caps, predicates, boundary, interval.exit_cap, meridian, +1));
  });
  return face;
}

// The free interval number k of a circle.
FreeInterval free_interval(const FreeIntervals &intervals, uint32_t k) {
  FreeInterval found{};
  uint32_t count = 0;
  intervals.visit([&](const FreeInterval &interval) {
    if (count++ == k) found = interval;
  });
  return found;
}

}  // namespace

uint32_t face_of_top(const CubeGrid &grid, const Boundary &boundary, uint32_t i, GatheredBall &gathered) {
  if (boundary.faces(i).size() == 1) return boundary.faces(i).first;
  gathered.gather(grid, i);
  return face_of_pole(boundary, gathered, +1);
}

uint32_t face_of_entry(const CubeGrid &grid, const Boundary &boundary, uint32_t i, int64_t x, int64_t y,
                       GatheredBall &gathered) {
  if (boundary.faces(i).size() == 1) return boundary.faces(i).first;
  gathered.gather(grid, i);
  const exact::LatticeBall own = grid.balls().ball(i);
  const int64_t dx = x - own.centre.x;
  const int64_t dy = y - own.centre.y;
  if (dx == 0 && dy == 0) return face_of_pole(boundary, gathered, -1);
  Caps &caps = gathered.caps;
  // The point is p+ of the great circle through it and the poles, and of the vertical plane across that circle.
  const exact::Predicates predicates = caps.predicates();
  const Plane meridian = exact::virtual_plane({-dy, dx, 0}, 0);
  const Plane across = exact::virtual_plane({dx, dy, 0}, 2 * (dx * dx + dy * dy));
  const FreeIntervals &intervals = gathered.intervals;
  gathered.intervals.find(caps, predicates, meridian);
  if (intervals.empty()) return face_of_pole(boundary, gathered, -1);  // free as a whole
  uint32_t count = 0;
  intervals.visit([&](const FreeInterval &) { ++count; });
  const auto planes_at_ends = [&](uint32_t k, Plane &leave, Plane &entry) {
    const FreeInterval interval = free_interval(intervals, k);
    leave = caps.plane[interval.exit_cap];
    entry = caps.plane[interval.entry_cap];
  };
  const uint32_t k = interval_that_contains(predicates, meridian, count, planes_at_ends, across, +1);
  const uint32_t exit_cap = free_interval(intervals, k).exit_cap;
  return boundary.face_of(locate_on_boundary(caps, predicates, boundary, exit_cap, meridian, +1));
}

}  // namespace hsp
