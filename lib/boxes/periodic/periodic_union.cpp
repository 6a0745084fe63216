#include "periodic/periodic_union.hpp"

#include <bit>

#include "model/set_digest.hpp"

namespace hsp {

void PeriodicUnion::carve(Workspace &workspace, const PeriodicLimits &limits) {
  limit(limits);
  counts_ = {};
  const uint32_t all = limits.balls + limits.images;
  images_.carve(workspace, limits.balls, limits.images);
  grid_.carve(workspace, all);
  boundary_.carve(workspace, {all, limits.neighbours, limits.vertices, limits.circles, limits.workers});
  contacts_.carve(workspace, {all, limits.neighbours, limits.contacts, 0, 0});
  windings_.carve(workspace, limits.balls);
  listed_vertices_.carve(workspace, limits.vertices);
  listed_half_edges_.carve(workspace, uint64_t{3} * limits.vertices);
  listed_circles_.carve(workspace, limits.circles);
}

Status PeriodicUnion::build(const BallInput &input, const double vector[9], const Executor &executor, bool areas_alone,
                            uint32_t &first_bad) {
  needed_ = {};
  counts_ = {};
  areas_alone_ = areas_alone;
  Patience patience(&executor);
  Status status = images_.build(input, vector, first_bad, patience);
  if (status != Status::ok && status != Status::capacity) return status;
  needed_.balls = input.n;
  needed_.images = clamped_count(images_.counted_images());
  if (status != Status::ok) return status;
  grid_.build(images_.in_steps(), images_.balls(), patience);
  if (!executor.goes_on()) return Status::stopped;
  status = boundary_.build_in_box(grid_, executor, !areas_alone);
  needed_.neighbours = boundary_.needed().neighbours;
  needed_.vertices = boundary_.needed().vertices;
  needed_.circles = boundary_.needed().circles;
  needed_.workers = boundary_.needed().workers;
  if (status != Status::ok) return status;
  for (uint32_t k = images_.balls(); k < images_.size(); ++k) {
    boundary_.take_state(grid_.grid_index(k), grid_.grid_index(images_.ball_of(k)));
  }
  if (areas_alone) return Status::ok;
  status = contacts_.build(grid_, boundary(), boundary_.needed().neighbours, ImagesInGrid(grid_, images_), patience);
  needed_.contacts = contacts_.needed().contacts;
  if (status != Status::ok) return status;
  if (!executor.goes_on()) return Status::stopped;
  status = join_balls(patience);
  return status == Status::ok ? count(patience) : status;
}

// The boundary has joined each ball in the box to those that meet it, with images as balls of their own. So an image
// joins the set that it is in to the set of its ball, at the image's shift.
Status PeriodicUnion::join_balls(Patience &patience) {
  const Span<const uint32_t> root = boundary_.joined_balls();
  windings_.reset(root.part(0, images_.balls()), balls().caller.part(0, images_.balls()));
  if (!patience.allows(50 * uint64_t{images_.balls()})) return Status::stopped;
  bool fits = true;
  for (uint32_t image = images_.balls(); image < images_.size(); ++image) {
    if (!patience.allows(200)) return Status::stopped;
    if (!is_in_box(root[image])) continue;  // no ball meets it
    const uint32_t k = balls().caller[image];
    const BoxShift shift = images_.box().in_given_vectors(images_.shift_of(k));
    fits = fits && windings_.join(balls().caller[root[image]], images_.ball_of(k), shift);
  }
  counts_.components = windings_.number();
  if (!patience.allows(50 * uint64_t{images_.balls()})) return Status::stopped;
  return fits ? Status::ok : Status::range;
}

Status PeriodicUnion::count(Patience &patience) {
  const Boundary &b = boundary();
  uint32_t half_edges = 0, closed = 0;
  for (uint32_t own = 0; own < images_.balls(); ++own) {
    half_edges += b.half_edges(own).size();
    closed += b.circles(own).size();
  }
  uint32_t across = 0;  // contacts with images: one from each side
  in_parts(patience, IdRange{0, contacts().contact_count()}, 10, [&](IdRange some) {
    for (const uint32_t id : some) across += is_in_box(contacts().contact(id).ball[1]) ? 0U : 1U;
  });
  if (!patience.allows(0)) return Status::stopped;
  // Each vertex starts three half-edges, each arc is two of them, each circle two loops.
  if (half_edges % 6 != 0 || closed % 2 != 0 || across % 2 != 0) return Status::check;
  counts_.vertices = half_edges / 3;
  counts_.arcs = half_edges / 2;
  counts_.circles = closed / 2;
  counts_.loops = b.loop_count();
  counts_.faces = b.face_count();
  counts_.contacts = contacts().contact_count() - across / 2;
  return list_vertices(patience) ? join_faces(patience) : Status::stopped;
}

// The other ball, at its place in the box, has the same half-edges, moved. The wanted one lies on the circle with the
// first ball, moved likewise, and begins at the vertex with the same third ball. Of the two points of three spheres
// only one is such a beginning.
uint32_t PeriodicUnion::half_edge_across(uint32_t ball, uint32_t half_edge) const {
  const Boundary &b = boundary();
  const uint32_t other = b.half_edge(half_edge).circle;
  if (is_in_box(other)) return b.twin(half_edge);
  const VertexRecord &end = b.vertex(b.end_vertex(half_edge));
  const uint32_t third = end.ball[0] ^ end.ball[1] ^ end.ball[2] ^ ball ^ other;
  const ImagesInGrid images(grid_, images_);
  const uint32_t opposite = images.ball_of(other);
  const uint32_t circle = images.moved_back(ball, other);
  const uint32_t previous = images.moved_back(third, other);
  for (const uint32_t e : b.half_edges(opposite)) {
    if (b.half_edge(e).circle == circle && b.previous_circle(opposite, b.half_edge(e)) == previous) return e;
  }
  return no_id;
}

bool PeriodicUnion::find_across(ClosedHalfEdge own, ClosedHalfEdge &across) const {
  const Boundary &b = boundary();
  const uint32_t other = b.neighbour(own);
  if (is_in_box(other)) {
    across = {own.circle(), 1 - own.side()};
    return true;
  }
  const ImagesInGrid images(grid_, images_);
  const uint32_t moved = images.moved_back(b.ball_of(own), other);
  for (const ClosedHalfEdge e : b.circles(images.ball_of(other))) {
    if (b.neighbour(e) != moved) continue;
    across = e;
    return true;
  }
  return false;
}

// Lists each vertex once. A vertex all of whose balls are in the box is there only once. Its balls are in ascending
// order.
bool PeriodicUnion::list_vertices(Patience &patience) {
  const Boundary &b = boundary();
  listed_vertices_.clear(b.vertex_count());
  in_parts(patience, IdRange{0, b.vertex_count()}, 50, [&](IdRange some) {
    for (const uint32_t v : some) {
      const VertexRecord &vertex = b.vertex(v);
      listed_vertices_.set_if(v, is_in_box(vertex.ball[2]) || is_in_box(in_listed_order(vertex).ball[0]));
    }
  });
  listed_vertices_.count();
  return patience.allows(0);
}

// Joins faces to shells. The faces at a vertex share arcs there, so that those of balls in the box are of one shell. So
// are the faces on both sides of an arc, or a circle, across a face of the box.
Status PeriodicUnion::join_faces(Patience &patience) {
  const Boundary &b = boundary();
  const Span<const uint32_t> caller = balls().caller;
  DisjointSets sets(boundary_.scratch().part(0, b.face_count()));
  sets.reset();
  in_parts(patience, IdRange{0, b.vertex_count()}, 100, [&](IdRange some) {
    for (const uint32_t v : some) {
      const VertexRecord &vertex = b.vertex(v);  // images are its last balls
      if (!is_in_box(vertex.ball[1])) continue;
      const uint32_t first = b.face_of(b.half_edge_at(v, 0));
      sets.join(first, b.face_of(b.half_edge_at(v, 1)));
      if (is_in_box(vertex.ball[2])) sets.join(first, b.face_of(b.half_edge_at(v, 2)));
    }
  });
  listed_half_edges_.clear(b.half_edge_count());
  listed_circles_.clear(b.circle_count());
  for (uint32_t own = 0; own < images_.balls(); ++own) {
    if (!patience.allows(1000)) return Status::stopped;
    for (const uint32_t e : b.half_edges(own)) {
      const uint32_t other = b.half_edge(e).circle;
      if (is_in_box(other)) {
        listed_half_edges_.set_if(e, caller[own] < caller[other]);
        continue;
      }
      if (!is_listed(caller[own], caller[other])) continue;
      const uint32_t across = half_edge_across(own, e);
      if (across == no_id) return Status::check;
      listed_half_edges_.set(e);
      sets.join(b.face_of(e), b.face_of(across));
    }
  }
  for (uint32_t c = 0; c < b.circle_count(); ++c) {
    const CircleRecord &circle = b.circle(c);  // an image is the last of its balls
    if (!is_in_box(circle.ball[1]) && !is_listed(caller[circle.ball[0]], caller[circle.ball[1]])) continue;
    ClosedHalfEdge across(0, 0);
    if (!find_across(ClosedHalfEdge(c, 0), across)) return Status::check;
    listed_circles_.set(c);
    sets.join(b.face_of_loop(circle.loop[0]), b.face_of_loop(b.loop_of(across)));
  }
  listed_half_edges_.count();
  listed_circles_.count();
  if (!patience.allows(100 * uint64_t{b.circle_count()})) return Status::stopped;
  boundary_.take_shells(sets);
  counts_.shells = b.shell_count();
  const bool each_once = listed_vertices_.size() == counts_.vertices && listed_half_edges_.size() == counts_.arcs &&
                         listed_circles_.size() == counts_.circles;
  return each_once ? Status::ok : Status::check;
}

uint64_t digest_of(const PeriodicUnion &periodic) {
  const PeriodicImages &images = periodic.images();
  const auto bits = [](int64_t number) { return static_cast<uint64_t>(number); };
  uint64_t sum = digest_of(periodic.grid());
  for (uint32_t k = 0; k < 3; ++k) {
    const exact::Vector &vector = images.box().given(k);
    sum += mixed(k, bits(vector.x), bits(vector.y), bits(vector.z));
    if (!images.box().frame().turns()) continue;
    const Vec3 &axis = images.box().frame().axis(static_cast<int>(k));
    sum += mixed(k, std::bit_cast<uint64_t>(axis.x), std::bit_cast<uint64_t>(axis.y), std::bit_cast<uint64_t>(axis.z));
  }
  for (uint32_t i = 0; i < images.balls(); ++i) {
    const BoxShift &home = images.home(i);
    sum += mixed(i, bits(home.k[0]), bits(home.k[1]), bits(home.k[2]));
  }
  return sum;
}

}  // namespace hsp
