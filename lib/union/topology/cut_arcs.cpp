// Finds the cut arcs of one face after the other.
//
// As an example the balls of radius 5 at (-8,0,0), (0,0,0) and (8,0,0). The face of the middle one is a band between
// the planes x = -4 and x = 4, with two loops, which are free circles of radius 3. The great circle through the axis of
// the first cap and the poles is in the plane y = 0, and its free pieces are
//   from (-4, 0, 3) over the top, (0, 0, 5), to (4, 0, 3)           passes the north pole
//   from (4, 0, -3) under the bottom, (0, 0, -5), to (-4, 0, -3)    passes the south pole
// The first piece joins the two loops. So both pieces are cut arcs, and no circle is tried for the second loop. Only
// one arc passes each pole, so that no vertex is made there. The band falls into two simple faces, each with one loop
// of four edges.
#include "topology/cut_arcs.hpp"

#include "model/block_sweep.hpp"

namespace hsp {
namespace {

// Which poles a free interval of a meridian passes. The tip of the axis for which the meridian was made is covered, and
// on the way from there the south pole comes first. So it does on an interval that passes both.
uint32_t poles_on(const Caps &caps, const exact::Predicates &predicates, const exact::Plane &meridian,
                  const FreeInterval &interval) {
  const bool north = contains_pole(caps, predicates, meridian, interval, +1);
  const bool south = contains_pole(caps, predicates, meridian, interval, -1);
  return (north ? CutArc::passes_north : 0U) | (south ? CutArc::passes_south : 0U) |
         (north && south ? CutArc::south_first : 0U);
}

// Makes vertices at poles. arcs: all cut arcs of one face; those that pass the same pole meet there.
void make_pole_vertices(Span<CutArc> arcs) {
  uint32_t north = 0;
  uint32_t south = 0;
  for (const CutArc &arc : arcs) {
    north += (arc.poles & CutArc::passes_north) != 0 ? 1U : 0U;
    south += (arc.poles & CutArc::passes_south) != 0 ? 1U : 0U;
  }
  for (CutArc &arc : arcs) {
    if (north > 1 && (arc.poles & CutArc::passes_north) != 0) arc.poles |= CutArc::vertex_at_north;
    if (south > 1 && (arc.poles & CutArc::passes_south) != 0) arc.poles |= CutArc::vertex_at_south;
  }
}

}  // namespace

void CutArcFinder::carve(Workspace &workspace, uint32_t neighbours) {
  pending_ = workspace.take<CutArc>(neighbours);
}

void CutArcFinder::find(const CubeGrid &grid, const Boundary &boundary, GatheredBall &gathered, Span<uint32_t> scratch,
                        Patience &patience, FixedVector<CutArc> &arcs) {
  arcs.clear();
  scratch_ = scratch;
  uint32_t gathered_ball = no_id;
  BlockSweep sweep(grid);
  uint64_t around = 0;  // number of caps of the ball before, an estimate
  for (uint32_t face = 0; face < boundary.face_count(); ++face) {
    const uint64_t loops = boundary.loops_of_face(face).size();
    if (loops < 2) continue;
    if (!patience.allows(2000 + loops * (1000 + 100 * around))) return;
    const uint32_t i = boundary.face(face).ball;
    if (i != gathered_ball) {
      gathered.gather(grid, sweep.block_around_ball(i), i);
      gathered.intervals.start(gathered.caps, boundary.loops(i).size());
      if (!small_code) find_first_elements(gathered.caps, boundary, gathered.intervals.of_caps());
      gathered_ball = i;
      around = gathered.caps.count;
    }
    cut_face(boundary, face, gathered, arcs);
  }
}

// A circle that only joins its loop to poles is kept in reserve: it is used if the others do not join all loops
// directly.
void CutArcFinder::cut_face(const Boundary &boundary, uint32_t face, GatheredBall &gathered,
                            FixedVector<CutArc> &arcs) {
  reset_nodes(boundary, face);
  const uint32_t first_arc = arcs.size();
  uint32_t reserved = 0;
  for (const uint32_t loop : boundary.loops_of_face(face)) {
    if (to_join_ == 0) break;
    const uint32_t cap = boundary.neighbour(boundary.loop_start(loop));
    if (!small_code && joins_nothing(gathered, cap)) continue;
    find_pieces(boundary, face, cap, gathered);
    const Joined joined = join_pieces(boundary);
    if (joined.loops) {
      push_pieces(arcs);
    } else if (joined.poles) {
      reserve_[reserved++] = loop;
    } else if (!small_code && ++in_vain_ >= most_in_vain && to_join_ <= to_join_when_marked_ / 2) {
      mark_caps_to_join(boundary, face, gathered);
    }
  }
  for (uint32_t k = 0; k < reserved && to_join_directly_ > 0; ++k) {
    find_pieces(boundary, face, boundary.neighbour(boundary.loop_start(reserve_[k])), gathered);
    push_pieces(arcs);
  }
  make_pole_vertices(arcs.items().part(first_arc, arcs.size()));
}

// If there are many loops, most circles would join nothing new. At a meridian without a mark all loops are joined to
// each other already, and to the poles in the face, as circles before have found them.
bool CutArcFinder::joins_nothing(const GatheredBall &gathered, uint32_t cap) const {
  const Caps &caps = gathered.caps;
  return has_marks_ && !gathered.intervals.is_marked(meridian_through(caps.direction(caps.cap_of(cap))));
}

void CutArcFinder::mark_caps_to_join(const Boundary &boundary, uint32_t face, const GatheredBall &gathered) {
  in_vain_ = 0;
  if (gathered.intervals.of_caps().empty()) return;
  const uint32_t all = nodes_.find(0), poles = nodes_.size() - 2;
  for (uint32_t pole = 0; pole < 2; ++pole) {
    if (pole_joined_[pole] && nodes_.find(poles + pole) != all) return;
  }
  has_marks_ = true;
  const MeridianSectors &sectors = gathered.intervals.sectors();
  sectors.clear_marks();
  to_join_when_marked_ = to_join_;
  const IdRange loops = boundary.loops_of_face(face);
  const auto is_to_join = [&](LoopElement element) {
    const uint32_t loop = boundary.loop_of(element);
    return loop >= loops.first && loop < loops.last && nodes_.find(loop - loops.first) != all;
  };
  const Span<const uint32_t> elements = gathered.intervals.of_caps();
  const uint32_t end = boundary.half_edges(gathered.caps.origin).last;
  for (uint32_t cap = 0; cap < elements.size(); ++cap) {
    if (elements[cap] == no_id) continue;
    const LoopElement first = LoopElement::from_code(elements[cap]);
    bool marks = is_to_join(first);
    if (!first.is_circle()) {
      const uint32_t circle = boundary.half_edge(first.half_edge()).circle;
      for (uint32_t e = first.half_edge() + 1; !marks && e < end && boundary.half_edge(e).circle == circle; ++e) {
        marks = is_to_join(LoopElement::arc(e));
      }
    }
    if (marks) sectors.mark(gathered.caps, cap);
  }
}

void CutArcFinder::reset_nodes(const Boundary &boundary, uint32_t face) {
  const uint32_t loops = boundary.loops_of_face(face).size();
  nodes_ = DisjointSets(scratch_.part(0, loops + 2));
  nodes_.reset();
  direct_ = DisjointSets(scratch_.part(loops + 2, 2 * loops + 2));
  direct_.reset();
  reserve_ = scratch_.part(2 * loops + 2, 3 * loops + 2);
  pole_joined_[0] = pole_joined_[1] = false;
  has_marks_ = false;
  to_join_when_marked_ = no_id;
  in_vain_ = 0;
  to_join_ = to_join_directly_ = loops - 1;
}

void CutArcFinder::push_pieces(FixedVector<CutArc> &arcs) const {
  for (uint32_t k = 0; k < pending_count_; ++k) arcs.push(pending_[k]);
}

void CutArcFinder::find_pieces(const Boundary &boundary, uint32_t face, uint32_t cap, GatheredBall &gathered) {
  Caps &caps = gathered.caps;
  const exact::Predicates predicates = caps.predicates();
  const exact::Plane meridian = meridian_through(caps.direction(caps.cap_of(cap)));
  gathered.intervals.find(caps, predicates, meridian);
  pending_count_ = 0;
  const Span<const uint32_t> elements = gathered.intervals.of_caps();
  gathered.intervals.visit([&](const FreeInterval &interval) {
    const LoopElement leave = locate_on_boundary(caps, predicates, boundary, interval.exit_cap, meridian, +1, elements);
    if (boundary.face_of(leave) != face) return;
    const LoopElement entry =
        locate_on_boundary(caps, predicates, boundary, interval.entry_cap, meridian, -1, elements);
    pending_[pending_count_++] = {
        caps.origin, cap, face, {leave, entry}, poles_on(caps, predicates, meridian, interval), {}};
  });
}

// First joins loops directly, then by the poles: the result must not depend on which of the circle's pieces is the
// first.
CutArcFinder::Joined CutArcFinder::join_pieces(const Boundary &boundary) {
  Joined joined{false, false};
  const auto node_at = [&boundary](const CutArc &arc, uint32_t end) {
    return boundary.loop_of(arc.end[end]) - boundary.loops_of_face(arc.face).first;
  };
  for (uint32_t k = 0; k < pending_count_; ++k) {
    if (!nodes_.join(node_at(pending_[k], 0), node_at(pending_[k], 1))) continue;
    --to_join_;
    joined.loops = true;
  }
  for (uint32_t k = 0; k < pending_count_ && joined.loops; ++k) {
    if (direct_.join(node_at(pending_[k], 0), node_at(pending_[k], 1))) --to_join_directly_;
  }
  for (uint32_t k = 0; k < pending_count_; ++k) {
    for (uint32_t pole = 0; pole < 2; ++pole) {
      if ((pending_[k].poles & (pole == 0 ? CutArc::passes_north : CutArc::passes_south)) == 0) continue;
      if (!nodes_.join(node_at(pending_[k], 0), nodes_.size() - 2 + pole)) continue;
      // The first piece through a pole joins its loop to the pole, but no two loops.
      if (pole_joined_[pole]) --to_join_;
      pole_joined_[pole] = true;
      joined.poles = true;
    }
  }
  return joined;
}

}  // namespace hsp
