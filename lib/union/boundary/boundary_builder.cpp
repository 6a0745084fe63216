// The boundary, stage by stage, by one worker or several. All of them end a stage before the next one begins.
//
//   search         each worker finds the vertices and circles of its cubes, each at the first of its balls
//   placing        the records of worker 0, of worker 1, .. in one array: ids do not depend on the number of workers
//   counting       the half-edges of each ball, also those of records that another worker has found
//   distributing   3 half-edges a vertex, 2 a circle, to the places of their balls
//   linking        the next half-edge of each; loops and faces, numbered with gaps between workers
//   closing_gaps   loops and faces get numbers without gaps
//   joining        faces that share an arc, to shells
//   numbering      shells, and components of balls
#include "boundary/boundary_builder.hpp"

namespace hsp {
namespace {

// The stages after the search. Each reads what all workers have done in the stages before.
enum Stage : uint32_t { placing, counting, distributing, linking, closing_gaps, joining, numbering };

}  // namespace

void BoundaryArrays::carve(Workspace &workspace, const BoundaryLimits &limits) {
  target = workspace.target();
  const uint64_t n = limits.balls;
  const uint64_t v = limits.vertices;
  const uint64_t loops = limits.most_loops();
  vertices = FixedVector<VertexRecord>(workspace.take<VertexRecord>(v));
  circles = FixedVector<CircleRecord>(workspace.take<CircleRecord>(limits.circles));
  root_discriminant = workspace.take<double>(v);
  first = workspace.take<FirstParts>(n + 1);
  half_edges = workspace.take<HalfEdge>(3 * v);
  half_edge_at = workspace.take<uint32_t>(3 * v);
  closed_half_edge = workspace.take<ClosedHalfEdge>(2 * static_cast<uint64_t>(limits.circles));
  loop_start = workspace.take<LoopElement>(loops);
  loop_face = workspace.take<uint32_t>(loops);
  faces = workspace.take<FaceRecord>(loops + n);
  workspace.take_each(n, ball_state, component_origin, component);
}

void BoundaryBuilder::carve(Workspace &workspace, const BoundaryLimits &limits) {
  limit(limits);
  arrays().carve(workspace, limits);
  scratch_ = workspace.take<uint32_t>(limits.most_loops() + limits.balls);
  selected_ = workspace.take<uint32_t>(limits.balls);
  const uint32_t count = larger_count(limits.workers, 1);
  workers_ = workspace.make<BoundaryWorker>(count);
  BoundaryWorker measured;  // for measuring, while there is no memory
  for (uint32_t w = 0; w < count; ++w) {
    BoundaryWorker &worker = workers_.empty() ? measured : workers_[w];
    worker.carve(workspace, limits, arrays(), w, scratch_);
  }
}

Status BoundaryBuilder::build(const CubeGrid &grid, const Executor &executor, const uint8_t *selected, bool joins,
                              bool whole) {
  needed_ = {};
  needed_.balls = grid.balls().n;
  needed_.workers = limits_.workers;
  const bool alone = executor.workers() == 1;
  if (!alone && executor.workers() > workers_.size()) needed_.workers = executor.workers();
  if (needed_.balls > limits_.balls || needed_.workers > limits_.workers) return Status::capacity;
  grid_ = &grid;
  count_ = alone ? 1 : workers_.size();
  joins_ = joins;
  whole_ = whole;
  const uint32_t *chosen = nullptr;
  if (selected != nullptr) {
    const Span<const uint32_t> caller = grid.balls().caller;
    const Span<uint32_t> of_grid = selected_;  // a copy: the compiler knows that it is not written to
    for (uint32_t i = 0; i < needed_.balls; ++i) of_grid[i] = selected[caller[i]];
    chosen = selected_.data();
  }
  for (uint32_t w = 0; w < count_; ++w) workers_[w].start(share_of(grid, w, count_), chosen, joins, &executor);
  const auto search = [this](uint32_t worker) { workers_[worker].search(*grid_, arrays().ball_state.data()); };
  if (!executor.for_each(count_, search)) return executor.failure();

  const Found all = found();
  needed_.neighbours = all.neighbours;
  // If there was no room for all neighbours of a ball, not all vertices have been looked for.
  if (all.neighbours > limits_.neighbours) return Status::capacity;
  needed_.vertices = clamped_count(all.vertices);
  needed_.circles = clamped_count(all.circles);
  if (all.vertices > limits_.vertices || all.circles > limits_.circles) return Status::capacity;

  arrays().balls = grid.own_balls();
  arrays().vertices.set_count(all.vertices);
  arrays().circles.set_count(all.circles);
  for (uint32_t stage = placing; stage <= numbering; ++stage) {
    const auto assemble_in = [this, stage](uint32_t worker) { assemble(stage, worker); };
    if (!executor.goes_on() || !executor.for_each(count_, assemble_in)) return executor.failure();
  }
  return Status::ok;
}

BoundaryBuilder::Found BoundaryBuilder::found() const {
  Found all;
  for (const BoundaryWorker &worker : at_work()) {
    all.neighbours = larger_count(all.neighbours, worker.neighbours());
    all.vertices += worker.vertices().required();
    all.circles += worker.circles().required();
  }
  return all;
}

void BoundaryBuilder::assemble(uint32_t stage, uint32_t worker) {
  BoundaryArrays &a = arrays();
  BoundaryWorker &own = workers_[worker];
  switch (stage) {
    case placing:
      place(worker);
      if (worker == 0 && joins_) join_components();
      break;
    case counting:
      own.count(a);
      break;
    case distributing:
      distribute(worker);
      break;
    case linking:
      link(worker);
      break;
    case closing_gaps:
      close_gaps(worker);
      break;
    case joining:
      if (shares_shells() && whole_) {
        SharedDisjointSets shells(scratch_.part(0, a.face_count));
        join_faces(boundary_, own.placed_vertices, own.placed_circles, own.patience(), shells);
      }
      break;
    default:
      if (!whole_) {
        if (worker == 0 && !joins_) leave_out_components();
        return;
      }
      // Worker 0 numbers the shells, the last worker the components.
      if (worker == 0 && shares_shells()) number_shells(DisjointSets(scratch_.part(0, a.face_count)), a);
      if (worker == 0 && !shares_shells()) find_shells(boundary_, a, scratch_, own.patience());
      if (worker < count_ - 1 || !own.patience().allows(50 * uint64_t{a.balls})) return;
      number_components(*grid_, own.patience(), a);
  }
}

// Puts a worker's vertices and circles behind those of the workers before it. As shares ascend, this is their order if
// one worker finds them all.
void BoundaryBuilder::place(uint32_t worker) {
  BoundaryArrays &a = arrays();
  BoundaryWorker &own = workers_[worker];
  uint32_t first_vertex = 0;
  uint32_t first_circle = 0;
  for (const BoundaryWorker &earlier : workers_.part(0, worker)) {
    first_vertex += earlier.vertices().size();
    first_circle += earlier.circles().size();
  }
  if (worker != 0) {
    for (uint32_t k = 0; k < own.vertices().size(); ++k) a.vertices.room()[first_vertex + k] = own.vertices()[k];
    for (uint32_t k = 0; k < own.circles().size(); ++k) a.circles.room()[first_circle + k] = own.circles()[k];
  }
  own.placed_vertices = {first_vertex, first_vertex + own.vertices().size()};
  own.placed_circles = {first_circle, first_circle + own.circles().size()};
  in_parts(own.patience(), own.placed_vertices, 100, [&](IdRange vertices) {
    BoundaryWorker::find_root_discriminants(grid_->balls(), vertices.first, vertices.last, a);
  });
}

// The sets of worker 0, in component_origin, become the sets of all. Balls behind those that worker 0 has met are not
// in them yet.
void BoundaryBuilder::join_components() {
  const uint32_t n = grid_->balls().n;
  const Span<uint32_t> parent = arrays().component_origin.part(0, n);
  for (uint32_t i = workers_[0].met().last; i < n; ++i) parent[i] = i;
  DisjointSets components(parent);
  for (const BoundaryWorker &worker : workers_.part(1, count_)) worker.join_components(components);
}

// Without components every ball is the origin of its own terms.
void BoundaryBuilder::leave_out_components() {
  BoundaryArrays &a = arrays();
  a.shell_count = a.component_count = 0;
  for (uint32_t i = 0; i < a.balls; ++i) a.component_origin[i] = i;
}

void BoundaryBuilder::distribute(uint32_t worker) {
  BoundaryArrays &a = arrays();
  BoundaryWorker &own = workers_[worker];
  HalfEdgeCounts before;
  for (const BoundaryWorker &earlier : workers_.part(0, worker)) {
    before.half_edges += earlier.counts.half_edges;
    before.closed += earlier.counts.closed;
  }
  distribute_half_edges(own.touching, before, own.patience(), a);
  if (worker + 1 < count_) return;
  a.first[a.balls].half_edge = before.half_edges + own.counts.half_edges;
  a.first[a.balls].closed_half_edge = before.closed + own.counts.closed;
}

void BoundaryBuilder::link(uint32_t worker) {
  BlockSweep sweep(*grid_);
  workers_[worker].link(grid_->balls(), sweep, boundary_, scratch_, arrays());
}

// Without the gaps, loops and faces have the numbers that one worker would give them. Worker 0 moves all of their
// records, in order, as a record may move to a place from which another one moves away. In other records each worker
// changes the numbers of its own loops and faces. If all workers are to join faces, each face becomes a set by itself.
void BoundaryBuilder::close_gaps(uint32_t worker) {
  BoundaryArrays &a = arrays();
  uint32_t loops = 0;
  uint32_t faces = 0;
  for (uint32_t w = 0; w < count_; ++w) {
    const BoundaryWorker &from = workers_[w];
    const uint32_t loops_down = from.loops.first - loops;
    const uint32_t faces_down = from.faces.first - faces;
    if (worker == w && shares_shells()) {
      for (const uint32_t face : from.faces) scratch_[face - faces_down] = face - faces_down;
    }
    if (worker == w && w != 0) return from.renumber(loops_down, faces_down, a);
    if (worker == 0 && w != 0) from.move_down(loops_down, faces_down, a);
    loops += from.loops.size();
    faces += from.faces.size();
  }
  a.first[a.balls].loop = a.loop_count = loops;
  a.first[a.balls].face = a.face_count = faces;
}

}  // namespace hsp
