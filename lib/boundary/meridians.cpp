// Nesting of loops on one sphere by walks along great circles. For one cap of every cluster take the great circle
// through the cap's axis and the poles. Both ends of a free arc of it lie on loops of one face: join them. All free
// arcs that contain a free pole are joined as well.
//
// This joins all loops l_1 .. l_r of a face f: the sphere minus f is r discs. The walk from a cluster in disc a to the
// pole leaves the disc through l_a, and each further disc it enters it leaves through that disc's loop, so the chain of
// joins links l_a to the loop of the pole's disc, or to the pole if that is free.
#include "sphere/great_circles.hpp"

namespace hsp {

void join_loops_by_meridians(const Caps &caps, const FaceScratch &scratch, const BoundaryStructure &boundary,
                             const DisjointSets &loops) {
  const exact::Predicates predicates = caps.predicates();
  const uint32_t first_loop = boundary.first_loop[caps.origin];
  uint32_t pole_loop = no_id;
  for (uint32_t representative = 0; representative < caps.count; ++representative) {
    if (scratch.cluster[representative] != representative) continue;
    const exact::Plane meridian = meridian_through(caps.plane[representative].v);
    const uint32_t owners = find_owners(caps, predicates, meridian, scratch);
    visit_owned_arcs(scratch, owners, [&](const OwnedArc &arc) {
      const uint32_t exit_loop =
          place_on_loops(caps, predicates, boundary, arc.exit_cap, meridian, +1).loop - first_loop;
      const uint32_t entry_loop =
          place_on_loops(caps, predicates, boundary, arc.entry_cap, meridian, -1).loop - first_loop;
      loops.join(exit_loop, entry_loop);
      if (arc_contains_pole(caps, predicates, meridian, arc, +1)) {
        if (pole_loop == no_id) pole_loop = exit_loop;
        loops.join(pole_loop, exit_loop);
      }
    });
  }
}

}  // namespace hsp
