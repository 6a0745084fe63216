// Great circles of one sphere in planes that contain the direction z, and how they cross the boundary of its free
// region. They tell which loops bound a common face (meridians.cpp), where a face with several loops can be cut, and
// in which face a point lies (lib/topology). All great circles of this kind pass through the sphere's poles, its
// highest and lowest points.
#pragma once

#include "boundary/faces.hpp"
#include "exact/angular_order.hpp"

namespace hsp {

// The great circle through the axis v and the poles; the one across x if the axis is the direction z itself.
exact::Plane meridian_through(const exact::Vector &axis);

// The caps that own free end points of a great circle, in cyclic order, go to scratch.owner; their number is returned.
// None if the circle is free as a whole or covered as a whole.
uint32_t find_owners(const Caps &caps, const exact::Predicates &predicates, const exact::Plane &circle,
                     const FaceScratch &scratch);

// The free arcs of a circle between its owners: counter-clockwise from the exit of one cap to the entry of the next.
struct OwnedArc {
  uint32_t exit_cap, entry_cap;
};
// Calls visit(arc) for each of them.
template <class Visit>
void visit_owned_arcs(const FaceScratch &scratch, uint32_t owners, Visit visit) {
  for (uint32_t a = 0; a < owners; ++a) {
    if (!FaceScratch::has_free_exit(scratch.owner[a])) continue;
    visit(OwnedArc{FaceScratch::cap_of_owner(scratch.owner[a]),
                   FaceScratch::cap_of_owner(scratch.owner[(a + 1) % owners])});
  }
}

// Where a free point of a cap's circle lies on the ball's loops: on the arc that a use walks, or on a free circle.
struct LoopPlace {
  uint32_t use;          // no_id on a free circle
  uint32_t circle_side;  // 2 * circle + side, no_id on an arc
  uint32_t loop;
};

// The place of the free point where the circle of a cap crosses another circle; sign as seen from that other circle, so
// that seen from the cap it is the opposite one.
LoopPlace place_on_loops(const Caps &caps, const exact::Predicates &predicates, const BoundaryStructure &boundary,
                         uint32_t cap, const exact::Plane &other, int sign);

// Which of several gaps of circle P, each from the exit of a plane to the entry of another, holds the free point of P
// and M with this sign. gap(g, leave, entry) stores the planes of gap g, 0 <= g < gaps.
//
// The exit and entry of a gap lie inside or outside M. A gap that M enters or leaves holds the entry or exit. If there
// is none, all ends lie on one side and one gap holds both points: the one around the mid-point of what M covers, or of
// what it does not cover.
template <class Gap>
uint32_t gap_that_holds(const exact::Predicates &predicates, const exact::Plane &P, uint32_t gaps, Gap gap,
                        const exact::Plane &M, int sign) {
  exact::Plane leave, entry;
  bool ends_inside = false;
  for (uint32_t g = 0; g < gaps && gaps > 1; ++g) {
    gap(g, leave, entry);
    const bool exit_inside = predicates.inside(P, leave, +1, M) > 0;
    const bool entry_inside = predicates.inside(P, entry, -1, M) > 0;
    if (exit_inside != entry_inside && (sign < 0) == entry_inside) return g;
    if (exit_inside == entry_inside) ends_inside = exit_inside;
  }
  const exact::Vector middle = ends_inside ? exact::Vector{-M.v.x, -M.v.y, -M.v.z} : M.v;
  for (uint32_t g = 0; g + 1 < gaps; ++g) {
    gap(g, leave, entry);
    if (exact::strictly_between(P.v, leave.v, middle, entry.v)) return g;
  }
  return gaps - 1;
}

// Whether a free arc of a meridian contains the sphere's highest (+1) or lowest (-1) point.
bool arc_contains_pole(const Caps &caps, const exact::Predicates &predicates, const exact::Plane &meridian,
                       const OwnedArc &arc, int pole);

}  // namespace hsp
