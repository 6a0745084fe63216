#include "topology/cut_arcs.hpp"

namespace hsp {
namespace {

uint32_t code_of(const LoopPlace &place) {
  return place.use != no_id ? place.use : ExtraArc::circle_bit | place.circle_side;
}

uint32_t loop_at_end(const BoundaryStructure &boundary, const ExtraArc &arc, uint32_t end) {
  if ((arc.end[end] & ExtraArc::circle_bit) == 0) return boundary.uses[arc.end[end]].loop;
  const uint32_t circle_side = arc.end[end] & ~ExtraArc::circle_bit;
  return boundary.circles[circle_side / 2].loop[circle_side % 2];
}

// Which poles a free arc of a meridian passes.
uint32_t poles_on(const Caps &caps, const exact::Predicates &predicates, const exact::Plane &meridian,
                  const OwnedArc &arc) {
  const bool north = arc_contains_pole(caps, predicates, meridian, arc, +1);
  const bool south = arc_contains_pole(caps, predicates, meridian, arc, -1);
  uint32_t poles = (north ? ExtraArc::passes_north : 0U) | (south ? ExtraArc::passes_south : 0U);
  if (north && south &&
      exact::counter_clockwise_before(meridian.v, caps.plane[arc.exit_cap].v, {0, 0, -1}, {0, 0, 1})) {
    poles |= ExtraArc::south_first;
  }
  return poles;
}

// All extra arcs of one face; those that pass a pole meet there.
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
  pending_ = workspace.take<ExtraArc>(neighbours);
  node_parent_ = workspace.take<uint32_t>(static_cast<uint64_t>(edges) + 2);
  direct_parent_ = workspace.take<uint32_t>(edges);
  reserve_ = workspace.take<uint32_t>(edges);
}

void ExtraArcFinder::find(const CubeGrid &grid, const BoundaryStructure &boundary, GatheredBall &gathered,
                          FixedVector<ExtraArc> &arcs) {
  arcs.clear();
  // Balls of one cube follow each other and share the block of cubes around it.
  uint32_t gathered_ball = no_id;
  BallRange cube_balls{0, 0};
  CubeBlock block;
  for (uint32_t face = 0; face < boundary.face_count; ++face) {
    if (boundary.faces[face].loops < 2) continue;
    const uint32_t i = boundary.faces[face].ball;
    if (i != gathered_ball) {
      if (i >= cube_balls.last) {
        const CubeCoordinates cube = GatheredBall::cube_of(grid, i);
        cube_balls = grid.balls_in_row(cube.x, cube.x, cube.y, cube.z);
        block = grid.block_around(cube);
      }
      gathered.gather(grid, block, i);
      gathered_ball = i;
    }
    cut_face(boundary, face, gathered, arcs);
  }
}

// A circle that joins nothing but poles waits in reserve: it is needed only if the others do not join the loops without
// the poles.
void ExtraArcFinder::cut_face(const BoundaryStructure &boundary, uint32_t face, const GatheredBall &gathered,
                              FixedVector<ExtraArc> &arcs) {
  const uint32_t i = boundary.faces[face].ball;
  reset_nodes(boundary, face);
  const uint32_t first_arc = arcs.size();
  uint32_t reserved = 0;
  for (uint32_t loop = boundary.first_loop[i]; loop < boundary.first_loop[i + 1] && to_join_ > 0; ++loop) {
    if (boundary.loop_face[loop] != face) continue;
    find_pieces(boundary, face, boundary.loop_cap[loop], gathered);
    const Joined joined = join_pieces(boundary);
    if (joined.loops) {
      push_pieces(arcs);
    } else if (joined.poles) {
      reserve_[reserved++] = loop;
    }
  }
  for (uint32_t k = 0; k < reserved && to_join_directly_ > 0; ++k) {
    find_pieces(boundary, face, boundary.loop_cap[reserve_[k]], gathered);
    push_pieces(arcs);
  }
  make_pole_vertices(arcs.items().part(first_arc, arcs.size()));
}

void ExtraArcFinder::reset_nodes(const BoundaryStructure &boundary, uint32_t face) {
  const uint32_t i = boundary.faces[face].ball;
  const uint32_t loops = boundary.first_loop[i + 1] - boundary.first_loop[i];
  nodes_ = DisjointSets(node_parent_.part(0, loops + 2));
  nodes_.reset();
  direct_ = DisjointSets(direct_parent_.part(0, loops));
  direct_.reset();
  pole_joined_[0] = pole_joined_[1] = false;
  to_join_ = to_join_directly_ = boundary.faces[face].loops - 1;
}

void ExtraArcFinder::push_pieces(FixedVector<ExtraArc> &arcs) const {
  for (uint32_t k = 0; k < pending_count_; ++k) arcs.push(pending_[k]);
}

void ExtraArcFinder::find_pieces(const BoundaryStructure &boundary, uint32_t face, uint32_t cap,
                                 const GatheredBall &gathered) {
  const Caps &caps = gathered.caps;
  const exact::Predicates predicates = caps.predicates();
  const exact::Plane meridian = meridian_through(caps.plane[caps.cap_of(cap)].v);
  const uint32_t owners = find_owners(caps, predicates, meridian, gathered.scratch);
  pending_count_ = 0;
  visit_owned_arcs(gathered.scratch, owners, [&](const OwnedArc &arc) {
    const LoopPlace leave = place_on_loops(caps, predicates, boundary, arc.exit_cap, meridian, +1);
    if (boundary.loop_face[leave.loop] != face) return;
    const LoopPlace entry = place_on_loops(caps, predicates, boundary, arc.entry_cap, meridian, -1);
    pending_[pending_count_++] = {
        caps.origin,   cap, face, {code_of(leave), code_of(entry)}, poles_on(caps, predicates, meridian, arc),
        {no_id, no_id}};
  });
}

// First directly, then by the poles: what is joined must not depend on where the circle's pieces start.
ExtraArcFinder::Joined ExtraArcFinder::join_pieces(const BoundaryStructure &boundary) {
  Joined joined{false, false};
  const auto node_at = [&boundary](const ExtraArc &arc, uint32_t end) {
    return loop_at_end(boundary, arc, end) - boundary.first_loop[arc.ball];
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
      if ((pending_[k].poles & (pole == 0 ? ExtraArc::passes_north : ExtraArc::passes_south)) == 0) continue;
      if (!nodes_.join(node_at(pending_[k], 0), nodes_.size() - 2 + pole)) continue;
      // The first circle through a pole joins no loops there.
      if (pole_joined_[pole]) --to_join_;
      pole_joined_[pole] = true;
      joined.poles = true;
    }
  }
  return joined;
}

}  // namespace hsp
