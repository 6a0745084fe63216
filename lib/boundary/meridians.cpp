// Nesting of loops on one sphere by walks along great circles. For one cap of every cluster take the great circle
// through the cap's axis and the poles. Both ends of a free arc of it lie on loops of one face: join them. All free
// arcs that contain a free pole are joined as well.
//
// This joins all loops l_1 .. l_r of a face f: the sphere minus f is r discs. The walk from a cluster in disc a to the
// pole leaves the disc through l_a, and each further disc it enters it leaves through that disc's loop, so the chain of
// joins links l_a to the loop of the pole's disc, or to the pole if that is free.
#include "boundary/faces.hpp"
#include "core/sorting.hpp"
#include "exact/cyclic_order.hpp"

namespace hsp {
namespace {

using exact::Plane;
using exact::Vector;

// The great circle through the axis v and the poles.
Plane meridian_through(const Vector &v) {
  return exact::virtual_plane(v.x != 0 || v.y != 0 ? Vector{-v.y, v.x, 0} : Vector{1, 0, 0}, 0);
}

// The pole is p+ of two coordinate planes. Their normals may have any length; the filter is sharpest if it is that of
// the others.
bool pole_is_free(const Caps &caps, const exact::Predicates &predicates) {
  int64_t scale = 1;
  while (4.0 * static_cast<double>(scale) * static_cast<double>(scale) <= caps.length_squared) scale *= 2;
  const Plane pole_plane_x = exact::virtual_plane({scale, 0, 0}, 0);
  const Plane pole_plane_y = exact::virtual_plane({0, scale, 0}, 0);
  for (uint32_t l = 0; l < caps.count; ++l) {
    if (predicates.inside(pole_plane_x, pole_plane_y, +1, caps.plane[l]) > 0) return false;
  }
  return true;
}

// The caps that own free end points of the meridian, in cyclic order; 4 * cap + 1 for a free entry + 2 for a free exit.
uint32_t find_owners(const Caps &caps, const exact::Predicates &predicates, const Plane &meridian,
                     const FaceScratch &scratch) {
  uint32_t crossings = 0;
  for (uint32_t l = 0; l < caps.count; ++l) {
    if (predicates.crossing(meridian, caps.plane[l]).sign > 0) {
      scratch.crossing[crossings++] = l;
    } else if (predicates.side(meridian, caps.plane[l]).sign > 0) {
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
      const exact::PointStatus status = predicates.point_status(meridian, Q, caps.plane[scratch.crossing[b]]);
      free_entry = free_entry && status.side[0] < 0;
      free_exit = free_exit && status.side[1] < 0;
    }
    if (free_entry || free_exit) {
      scratch.owner[owners++] = 4 * scratch.crossing[a] + (free_entry ? 1U : 0U) + (free_exit ? 2U : 0U);
    }
  }
  if (owners > 2) {
    const Vector reference = caps.plane[scratch.owner[0] / 4].v;
    sort_in_place(scratch.owner.part(1, owners), [&](uint32_t a, uint32_t b) {
      return exact::counter_clockwise_before(meridian.v, reference, caps.plane[a / 4].v, caps.plane[b / 4].v);
    });
  }
  return owners;
}

// A free arc of a circle, counter-clockwise from the exit of one cap to the entry of another.
struct FreeArc {
  uint32_t exit_cap, entry_cap;
  uint32_t loop;
};

FreeArc arc_of_use(const Caps &caps, const BoundaryStructure &boundary, uint32_t use) {
  const VertexUse &walk = boundary.uses[use];
  return {caps.cap_of(boundary.uses[walk.next].out), caps.cap_of(walk.in), walk.loop};
}

// The loop through the free point of circle Q on the meridian; sign as seen from the meridian, so that seen from Q it
// is the opposite one. If Q has several free arcs, the one that holds the point is told by where its ends lie to the
// meridian.
uint32_t loop_at(const Caps &caps, const exact::Predicates &predicates, const BoundaryStructure &boundary, uint32_t cap,
                 const Plane &meridian, int sign) {
  const uint32_t i = caps.origin;
  const uint32_t other = caps.ball[cap];
  for (uint32_t s = boundary.first_circle_side[i]; s < boundary.first_circle_side[i + 1]; ++s) {
    const uint32_t side = boundary.circle_side[s] % 2;
    const CircleRecord &circle = boundary.circles[boundary.circle_side[s] / 2];
    if (circle.ball[1 - side] == other) return circle.loop[side];
  }
  const Plane &Q = caps.plane[cap];
  uint32_t only = no_id;
  uint32_t arcs = 0;
  bool ends_inside = false;
  for (uint32_t u = boundary.first_use[i]; u < boundary.first_use[i + 1]; ++u) {
    if (boundary.uses[u].out != other) continue;
    const FreeArc arc = arc_of_use(caps, boundary, u);
    only = arc.loop;
    ++arcs;
    const bool exit_inside = predicates.inside(Q, caps.plane[arc.exit_cap], +1, meridian) > 0;
    const bool entry_inside = predicates.inside(Q, caps.plane[arc.entry_cap], -1, meridian) > 0;
    // Seen from Q the meridian covers an arc from its entry (-sign < 0) to its exit.
    if (exit_inside != entry_inside && (-sign < 0) == entry_inside) return arc.loop;
    if (exit_inside == entry_inside) ends_inside = exit_inside;
  }
  if (arcs == 1) return only;
  // The meridian, or its complement, lies inside one free arc: the one with its mid-point.
  const Vector middle = ends_inside ? Vector{-meridian.v.x, -meridian.v.y, -meridian.v.z} : meridian.v;
  for (uint32_t u = boundary.first_use[i]; u < boundary.first_use[i + 1]; ++u) {
    if (boundary.uses[u].out != other) continue;
    const FreeArc arc = arc_of_use(caps, boundary, u);
    if (exact::strictly_between(Q.v, caps.plane[arc.exit_cap].v, middle, caps.plane[arc.entry_cap].v)) return arc.loop;
  }
  return only;  // GCOVR_EXCL_LINE: one of the arcs holds the free point
}

}  // namespace

void join_loops_by_meridians(const Caps &caps, const FaceScratch &scratch, const BoundaryStructure &boundary,
                             const DisjointSets &loops) {
  const exact::Predicates predicates = caps.predicates();
  const uint32_t first_loop = boundary.first_loop[caps.origin];
  const bool free_pole = pole_is_free(caps, predicates);
  uint32_t pole_loop = no_id;
  for (uint32_t representative = 0; representative < caps.count; ++representative) {
    if (scratch.cluster[representative] != representative) continue;
    const Plane meridian = meridian_through(caps.plane[representative].v);
    const uint32_t owners = find_owners(caps, predicates, meridian, scratch);
    for (uint32_t a = 0; a < owners; ++a) {
      if ((scratch.owner[a] & 2U) == 0) continue;
      const uint32_t exit_cap = scratch.owner[a] / 4;
      const uint32_t entry_cap = scratch.owner[(a + 1) % owners] / 4;
      const uint32_t exit_loop = loop_at(caps, predicates, boundary, exit_cap, meridian, +1) - first_loop;
      const uint32_t entry_loop = loop_at(caps, predicates, boundary, entry_cap, meridian, -1) - first_loop;
      loops.join(exit_loop, entry_loop);
      if (free_pole &&
          exact::strictly_between(meridian.v, caps.plane[exit_cap].v, {0, 0, 1}, caps.plane[entry_cap].v)) {
        if (pole_loop == no_id) pole_loop = exit_loop;
        loops.join(pole_loop, exit_loop);
      }
    }
  }
}

}  // namespace hsp
