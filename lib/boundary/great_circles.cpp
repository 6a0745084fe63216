#include "boundary/great_circles.hpp"

#include "core/sorting.hpp"

namespace hsp {

using exact::Plane;
using exact::Vector;

// Odd in the axis, so that both balls of a circle name its points in the plane by the same signs.
Plane meridian_through(const Vector &axis) {
  if (axis.x != 0 || axis.y != 0) return exact::virtual_plane({-axis.y, axis.x, 0}, 0);
  return exact::virtual_plane({axis.z > 0 ? 1 : -1, 0, 0}, 0);
}

// The poles are p+ and p- of two coordinate planes. Their normals may have any length; the filter is sharpest if it is
// that of the others.
bool pole_is_free(const Caps &caps, const exact::Predicates &predicates, int pole) {
  int64_t scale = 1;
  while (4.0 * static_cast<double>(scale) * static_cast<double>(scale) <= caps.length_squared) scale *= 2;
  const Plane pole_plane_x = exact::virtual_plane({scale, 0, 0}, 0);
  const Plane pole_plane_y = exact::virtual_plane({0, scale, 0}, 0);
  for (uint32_t l = 0; l < caps.count; ++l) {
    if (predicates.inside(pole_plane_x, pole_plane_y, pole, caps.plane[l]) > 0) return false;
  }
  return true;
}

uint32_t find_owners(const Caps &caps, const exact::Predicates &predicates, const Plane &circle,
                     const FaceScratch &scratch) {
  uint32_t crossings = 0;
  for (uint32_t l = 0; l < caps.count; ++l) {
    if (predicates.crossing(circle, caps.plane[l]).sign > 0) {
      scratch.crossing[crossings++] = l;
    } else if (predicates.side(circle, caps.plane[l]).sign > 0) {
      return 0;
    }
  }
  uint32_t owners = 0;
  for (uint32_t a = 0; a < crossings; ++a) {
    const Plane &Q = caps.plane[scratch.crossing[a]];
    bool free_entry = true;
    bool free_exit = true;
    for (uint32_t b = 0; b < crossings && (free_entry || free_exit); ++b) {
      if (a == b) continue;
      const exact::PointStatus status = predicates.point_status(circle, Q, caps.plane[scratch.crossing[b]]);
      free_entry = free_entry && status.side[0] < 0;
      free_exit = free_exit && status.side[1] < 0;
    }
    if (free_entry || free_exit) {
      scratch.owner[owners++] = FaceScratch::owner_of(scratch.crossing[a], free_entry, free_exit);
    }
  }
  if (owners > 2) {
    const Vector reference = caps.plane[FaceScratch::cap_of_owner(scratch.owner[0])].v;
    sort_in_place(scratch.owner.part(1, owners), [&](uint32_t a, uint32_t b) {
      return exact::counter_clockwise_before(circle.v, reference, caps.plane[FaceScratch::cap_of_owner(a)].v,
                                             caps.plane[FaceScratch::cap_of_owner(b)].v);
    });
  }
  return owners;
}

LoopPlace place_on_loops(const Caps &caps, const exact::Predicates &predicates, const BoundaryStructure &boundary,
                         uint32_t cap, const Plane &other, int sign) {
  const uint32_t i = caps.origin;
  const uint32_t neighbour = caps.ball[cap];
  for (uint32_t s = boundary.first_circle_side[i]; s < boundary.first_circle_side[i + 1]; ++s) {
    const uint32_t side = boundary.circle_side[s] % 2;
    const CircleRecord &circle = boundary.circles[boundary.circle_side[s] / 2];
    if (circle.ball[1 - side] == neighbour) return {no_id, boundary.circle_side[s], circle.loop[side]};
  }
  // The uses are sorted by the circle they leave along, so the arcs of one circle are consecutive.
  uint32_t first = boundary.first_use[i];
  while (boundary.uses[first].out != neighbour) ++first;
  uint32_t last = first + 1;
  while (last < boundary.first_use[i + 1] && boundary.uses[last].out == neighbour) ++last;
  const auto gap = [&](uint32_t g, Plane &exit, Plane &entry) {
    const VertexUse &walk = boundary.uses[first + g];
    exit = caps.plane[caps.cap_of(boundary.uses[walk.next].out)];
    entry = caps.plane[caps.cap_of(walk.in)];
  };
  const uint32_t use = first + gap_that_holds(predicates, caps.plane[cap], last - first, gap, other, -sign);
  return {use, no_id, boundary.uses[use].loop};
}

}  // namespace hsp
