#include "boundary/point_location.hpp"

#include "sphere/great_circles.hpp"

namespace hsp {

namespace {

// A great circle through the pole and the axis of a cap is covered there, so that its free arc around the pole has
// ends, which lie on loops of the face.
uint32_t face_of_pole(const BoundaryStructure &boundary, const GatheredBall &gathered, int pole) {
  const Caps &caps = gathered.caps;
  const exact::Predicates predicates = caps.predicates();
  const exact::Plane meridian = meridian_through(caps.plane[0].v);
  const uint32_t owners = find_owners(caps, predicates, meridian, gathered.scratch);
  uint32_t face = boundary.first_face[caps.origin];
  visit_owned_arcs(gathered.scratch, owners, [&](const OwnedArc &arc) {
    if (!arc_contains_pole(caps, predicates, meridian, arc, pole)) return;
    face = boundary.loop_face[place_on_loops(caps, predicates, boundary, arc.exit_cap, meridian, +1).loop];
  });
  return face;
}

}  // namespace

uint32_t face_of_top(const CubeGrid &grid, const BoundaryStructure &boundary, uint32_t i, GatheredBall &gathered) {
  if (boundary.first_face[i + 1] - boundary.first_face[i] == 1) return boundary.first_face[i];
  gathered.gather(grid, i);
  return face_of_pole(boundary, gathered, +1);
}

uint32_t face_of_entry(const CubeGrid &grid, const BoundaryStructure &boundary, uint32_t i, int64_t x, int64_t y,
                       GatheredBall &gathered) {
  if (boundary.first_face[i + 1] - boundary.first_face[i] == 1) return boundary.first_face[i];
  gathered.gather(grid, i);
  const exact::LatticeBall own = grid.balls().ball(i);
  const int64_t dx = x - own.centre.x;
  const int64_t dy = y - own.centre.y;
  if (dx == 0 && dy == 0) return face_of_pole(boundary, gathered, -1);
  const Caps &caps = gathered.caps;
  // The point is p+ of the great circle through it and the poles, and of the vertical plane across that circle.
  const exact::Predicates predicates = caps.predicates();
  const exact::Plane meridian = exact::virtual_plane({-dy, dx, 0}, 0);
  const exact::Plane across = exact::virtual_plane({dx, dy, 0}, 2 * (dx * dx + dy * dy));
  const uint32_t owners = find_owners(caps, predicates, meridian, gathered.scratch);
  if (owners == 0) return face_of_pole(boundary, gathered, -1);  // free as a whole
  uint32_t gaps = 0;
  visit_owned_arcs(gathered.scratch, owners, [&](const OwnedArc &) { ++gaps; });
  const auto arc_of_gap = [&](uint32_t gap) {
    OwnedArc found{};
    uint32_t count = 0;
    visit_owned_arcs(gathered.scratch, owners, [&](const OwnedArc &arc) {
      if (count++ == gap) found = arc;
    });
    return found;
  };
  const auto planes_of_gap = [&](uint32_t gap, exact::Plane &leave, exact::Plane &entry) {
    const OwnedArc arc = arc_of_gap(gap);
    leave = caps.plane[arc.exit_cap];
    entry = caps.plane[arc.entry_cap];
  };
  const OwnedArc arc = arc_of_gap(gap_that_holds(predicates, meridian, gaps, planes_of_gap, across, +1));
  return boundary.loop_face[place_on_loops(caps, predicates, boundary, arc.exit_cap, meridian, +1).loop];
}

}  // namespace hsp
