#include "topology/extra_arcs.hpp"

#include "boundary/great_circles.hpp"
#include "core/sorting.hpp"

namespace hsp {
namespace {

uint32_t code_of(const LoopPlace &place) {
  return place.use != no_id ? place.use : ExtraArc::circle_bit | place.circle_side;
}

bool has_face_with_several_loops(const BoundaryStructure &boundary, uint32_t i) {
  const uint32_t loops = boundary.first_loop[i + 1] - boundary.first_loop[i];
  const uint32_t faces = boundary.first_face[i + 1] - boundary.first_face[i];
  return faces > 0 && loops > faces;
}

// All arcs of one ball that pass a pole lie in the face that holds it.
void make_pole_vertices(Span<ExtraArc> arcs) {
  uint32_t north = 0;
  uint32_t south = 0;
  for (const ExtraArc &arc : arcs) {
    north += (arc.poles & ExtraArc::passes_north) != 0 ? 1U : 0U;
    south += (arc.poles & ExtraArc::passes_south) != 0 ? 1U : 0U;
  }
  for (ExtraArc &arc : arcs) {
    if (north > 1 && (arc.poles & ExtraArc::passes_north) != 0) arc.poles |= ExtraArc::vertex_at_north;
    if (south > 1 && (arc.poles & ExtraArc::passes_south) != 0) arc.poles |= ExtraArc::vertex_at_south;
  }
}

}  // namespace

void ExtraArcFinder::carve(Workspace &workspace, uint32_t neighbours, uint32_t edges) {
  representative_ = workspace.take<uint32_t>(neighbours);
  pending_ = workspace.take<ExtraArc>(neighbours);
  loop_parent_ = workspace.take<uint32_t>(static_cast<uint64_t>(edges) + 2);
  joined_by_ = workspace.take<uint32_t>(edges);
}

void ExtraArcFinder::find(const CubeGrid &grid, const BoundaryStructure &boundary, GatheredBall &gathered,
                          FixedVector<ExtraArc> &arcs) {
  arcs.clear();
  for (uint32_t i = 0; i < grid.balls().n; ++i) {
    if (!has_face_with_several_loops(boundary, i)) continue;
    gathered.gather(grid, i);
    cut_ball(boundary, gathered, arcs);
  }
}

// One cap per cluster, in the order of rank. Leaves their number.
uint32_t ExtraArcFinder::sort_representatives(const GatheredBall &gathered) {
  const Caps &caps = gathered.caps;
  count_clusters(caps, gathered.scratch);
  const DisjointSets clusters(gathered.scratch.cluster.part(0, caps.count));
  const Span<uint32_t> lowest = gathered.scratch.owner;  // by cluster
  for (uint32_t j = 0; j < caps.count; ++j) lowest[j] = no_id;
  for (uint32_t j = 0; j < caps.count; ++j) {
    uint32_t &best = lowest[clusters.find(j)];
    if (best == no_id || exact::ranks_before(caps.plane[j], caps.plane[best])) best = j;
  }
  uint32_t count = 0;
  for (uint32_t j = 0; j < caps.count; ++j) {
    if (lowest[j] != no_id) representative_[count++] = lowest[j];
  }
  sort_in_place(representative_.part(0, count),
                [&caps](uint32_t a, uint32_t b) { return exact::ranks_before(caps.plane[a], caps.plane[b]); });
  return count;
}

void ExtraArcFinder::cut_ball(const BoundaryStructure &boundary, const GatheredBall &gathered,
                              FixedVector<ExtraArc> &arcs) {
  const Caps &caps = gathered.caps;
  const FaceScratch &scratch = gathered.scratch;
  const uint32_t i = caps.origin;
  const uint32_t first_loop = boundary.first_loop[i];
  const uint32_t loops = boundary.first_loop[i + 1] - first_loop;
  const uint32_t first_face = boundary.first_face[i];
  const uint32_t faces = boundary.first_face[i + 1] - first_face;
  const exact::Predicates predicates = caps.predicates();
  const bool north_free = pole_is_free(caps, predicates, +1);
  const bool south_free = pole_is_free(caps, predicates, -1);
  const uint32_t clusters = sort_representatives(gathered);

  // The poles are nodes like the loops: circles that meet in a pole are joined there.
  const uint32_t north = loops;
  const uint32_t south = loops + 1;
  const DisjointSets nodes(loop_parent_.part(0, loops + 2));
  nodes.reset();
  for (uint32_t f = 0; f < faces; ++f) joined_by_[f] = no_id;
  uint32_t to_join = loops - faces;  // until every face is joined
  bool pole_joined[2] = {false, false};
  const uint32_t first_arc = arcs.size();

  for (uint32_t c = 0; c < clusters && to_join > 0; ++c) {
    const exact::Plane meridian = meridian_through(caps.plane[representative_[c]].v);
    const uint32_t owners = find_owners(caps, predicates, meridian, scratch);
    uint32_t count = 0;
    visit_owned_arcs(scratch, owners, [&](const OwnedArc &arc) {
      const LoopPlace exit = place_on_loops(caps, predicates, boundary, arc.exit_cap, meridian, +1);
      const uint32_t face = boundary.loop_face[exit.loop];
      if (boundary.faces[face].loops == 1) return;
      const LoopPlace entry = place_on_loops(caps, predicates, boundary, arc.entry_cap, meridian, -1);
      const bool passes_north = north_free && arc_contains_pole(caps, meridian, arc, +1);
      const bool passes_south = south_free && arc_contains_pole(caps, meridian, arc, -1);
      uint32_t poles = (passes_north ? ExtraArc::passes_north : 0U) | (passes_south ? ExtraArc::passes_south : 0U);
      if (passes_north && passes_south &&
          exact::strictly_between(meridian.v, caps.plane[arc.exit_cap].v, {0, 0, -1}, {0, 0, 1})) {
        poles |= ExtraArc::south_first;
      }
      pending_[count++] = {i, caps.ball[representative_[c]], face, {code_of(exit), code_of(entry)}, poles};

      const uint32_t node = exit.loop - first_loop;
      const auto join_pole = [&](uint32_t pole) {
        if (!nodes.join(node, pole)) return;
        joined_by_[face - first_face] = c;
        if (pole_joined[pole - north]) --to_join;
        pole_joined[pole - north] = true;
      };
      if (nodes.join(node, entry.loop - first_loop)) {
        joined_by_[face - first_face] = c;
        --to_join;
      }
      if (passes_north) join_pole(north);
      if (passes_south) join_pole(south);
    });
    for (uint32_t a = 0; a < count; ++a) {
      if (joined_by_[pending_[a].face - first_face] == c) arcs.push(pending_[a]);
    }
  }
  make_pole_vertices(arcs.items().part(first_arc, arcs.size()));
}

}  // namespace hsp
