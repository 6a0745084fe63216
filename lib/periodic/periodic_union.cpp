#include "periodic/periodic_union.hpp"

#include "periodic/periodic_queries.hpp"

namespace hsp {

void PeriodicUnion::carve(Workspace &workspace, const PeriodicLimits &limits) {
  limits_ = limits;
  needed_ = {};
  counts_ = {};
  const uint32_t all = limits.balls + limits.images;
  images_.carve(workspace, limits.balls, limits.images);
  grid_.carve(workspace, all);
  boundary_.carve(workspace, {all, limits.neighbours, limits.vertices, limits.circles, 1});
  contacts_.carve(workspace, {all, limits.neighbours, limits.contacts, 0, 0});
  windings_.carve(workspace, limits.balls);
}

Status PeriodicUnion::build(const BallInput &input, const double vector[9], uint32_t &first_bad) {
  needed_ = {};
  counts_ = {};
  Status status = images_.build(input, vector, first_bad);
  if (status != Status::ok && status != Status::capacity) return status;
  needed_.balls = input.n;
  needed_.images = clamped_count(images_.counted_images());
  if (status != Status::ok) return status;
  grid_.build(images_.in_steps(), images_.balls());
  status = boundary_.build(grid_);
  needed_.neighbours = boundary_.needed().neighbours;
  needed_.vertices = boundary_.needed().vertices;
  needed_.circles = boundary_.needed().circles;
  if (status != Status::ok) return status;
  for (uint32_t k = images_.balls(); k < images_.size(); ++k) {
    boundary_.take_state(grid_.grid_index(k), grid_.grid_index(images_.ball_of(k)));
  }
  status = contacts_.build(grid_, boundary(), boundary_.needed().neighbours);
  needed_.contacts = contacts_.needed().contacts;
  if (status != Status::ok) return status;
  status = join_balls();
  return status == Status::ok ? count() : status;
}

// The union and its dual complex, whose edges are contacts, have the same components and windings: Edelsbrunner 1995,
// for all copies of the box. Balls without a contact may have no cell: they are joined to all that meet them.
Status PeriodicUnion::join_balls() {
  windings_.reset(images_.balls());
  bool fits = true;
  for (uint32_t i = 0; i < images_.balls(); ++i) {
    const auto join = [&](uint32_t other) {
      const BoxShift shift = images_.box().in_given_vectors(images_.shift_of(other));
      fits = fits && windings_.join(i, images_.ball_of(other), shift);
    };
    const uint32_t own = grid_.grid_index(i);
    if (contacts().row(own).empty() && !boundary().is_free_of_caps(own)) {
      visit_neighbours_in_box(*this, i, join);
      continue;
    }
    // Each once: what is across a face of the box is there again the other way round.
    visit_contacts_of(i, [&](const PeriodicContact &contact) {
      if (is_listed(contact)) join(contact.other);
    });
  }
  counts_.components = windings_.number();
  return fits ? Status::ok : Status::range;
}

Status PeriodicUnion::count() {
  const Boundary &b = boundary();
  uint64_t half_edges = 0, closed = 0;
  for (uint32_t i = 0; i < images_.balls(); ++i) {
    const uint32_t ball = grid_.grid_index(i);
    half_edges += b.half_edges(ball).size();
    closed += b.circles(ball).size();
    counts_.loops += b.loops(ball).size();
    counts_.faces += b.faces(ball).size();
    visit_contacts_of(i, [&](const PeriodicContact &contact) { counts_.contacts += is_listed(contact) ? 1U : 0U; });
  }
  // Each vertex starts three half-edges, each arc is two of them, each circle two loops.
  if (half_edges % 6 != 0 || closed % 2 != 0) return Status::check;
  counts_.vertices = static_cast<uint32_t>(half_edges / 3);
  counts_.arcs = static_cast<uint32_t>(half_edges / 2);
  counts_.circles = static_cast<uint32_t>(closed / 2);
  return find_shells();
}

// Ball or image of the grid, moved by a shift; no_id if it is not in the set.
uint32_t PeriodicUnion::grid_index_moved(uint32_t grid_ball, const BoxShift &shift) const {
  const uint32_t k = balls().caller[grid_ball];
  const uint32_t moved = images_.find(images_.ball_of(k), images_.shift_of(k) + shift);
  return moved == no_id ? no_id : grid_.grid_index(moved);
}

// The face on the other side of an arc of a ball in the box: of the other ball's copy in the box, which has the same
// half-edges about its own place. The one that is meant lies on the circle of the first ball, moved likewise, and
// begins where the circle of the vertex's third ball ends: of the two points of three spheres one is such a beginning.
uint32_t PeriodicUnion::face_across(uint32_t ball, uint32_t half_edge) const {
  const Boundary &b = boundary();
  const uint32_t other = b.half_edge(half_edge).circle;
  const VertexRecord &end = b.vertex(b.end_vertex(half_edge));
  const uint32_t third = end.ball[0] ^ end.ball[1] ^ end.ball[2] ^ ball ^ other;
  const BoxShift back = BoxShift{} - images_.shift_of(balls().caller[other]);
  const uint32_t opposite = grid_index_moved(other, back);
  const uint32_t circle = grid_index_moved(ball, back);
  const uint32_t previous = grid_index_moved(third, back);
  for (const uint32_t e : b.half_edges(opposite)) {
    if (b.half_edge(e).circle == circle && b.previous_circle(opposite, b.half_edge(e)) == previous) {
      return b.face_of(e);
    }
  }
  return no_id;
}

uint32_t PeriodicUnion::face_across(uint32_t ball, ClosedHalfEdge circle) const {
  const Boundary &b = boundary();
  const uint32_t other = b.neighbour(circle);
  const BoxShift back = BoxShift{} - images_.shift_of(balls().caller[other]);
  const uint32_t opposite = grid_index_moved(other, back);
  const uint32_t moved = grid_index_moved(ball, back);
  for (const ClosedHalfEdge e : b.circles(opposite)) {
    if (b.neighbour(e) == moved) return b.face_of_loop(b.loop_of(e));
  }
  return no_id;
}

// Faces of balls in the box are joined across their arcs and circles.
Status PeriodicUnion::find_shells() {
  const Boundary &b = boundary();
  const Span<uint32_t> parent = boundary_.scratch().part(0, b.face_count());
  DisjointSets sets(parent);
  sets.reset();
  for (uint32_t i = 0; i < images_.balls(); ++i) {
    const uint32_t ball = grid_.grid_index(i);
    for (const uint32_t e : b.half_edges(ball)) {
      const uint32_t across = is_in_box(b.half_edge(e).circle) ? b.face_of(b.twin(e)) : face_across(ball, e);
      if (across == no_id) return Status::check;
      sets.join(b.face_of(e), across);
    }
    for (const ClosedHalfEdge e : b.circles(ball)) {
      const uint32_t across = face_across(ball, e);
      if (across == no_id) return Status::check;
      sets.join(b.face_of_loop(b.loop_of(e)), across);
    }
  }
  for (uint32_t i = 0; i < images_.balls(); ++i) {
    for (const uint32_t face : b.faces(grid_.grid_index(i))) counts_.shells += parent[face] == face ? 1U : 0U;
  }
  return Status::ok;
}

}  // namespace hsp
