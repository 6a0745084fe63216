#include "moving/boundary_part.hpp"

namespace hsp {

void BoundaryPart::carve(Workspace &workspace, const BoundaryLimits &limits) {
  limit(limits);
  arrays().carve(workspace, limits);
  scratch_ = workspace.take<uint32_t>(limits.most_loops() + limits.balls);
  worker_ = workspace.make<BoundaryWorker>(1);
  BoundaryWorker measured;  // while there is no memory
  (worker_.empty() ? measured : worker_[0]).carve(workspace, limits, arrays(), 0, scratch_);
}

Status BoundaryPart::build(const BallSet &balls, uint32_t own, const double (&centre)[3], double side) {
  BoundaryArrays &a = arrays();
  BoundaryWorker &worker = worker_[0];
  worker.start({0, 0, {0, own}}, nullptr, false);
  worker.search(balls, centre, side, a.ball_state.data());
  const uint64_t vertices = worker.vertices().required(), circles = worker.circles().required();
  needed_ = {};
  needed_.neighbours = worker.neighbours();
  if (needed_.neighbours > limits_.neighbours) return Status::capacity;
  needed_.vertices = clamped_count(vertices);
  needed_.circles = clamped_count(circles);
  if (vertices > limits_.vertices || circles > limits_.circles) return Status::capacity;

  a.balls = own;
  a.vertices.set_count(vertices);
  a.circles.set_count(circles);

  worker.placed_vertices = {0, a.vertices.size()};
  worker.placed_circles = {0, a.circles.size()};
  BoundaryWorker::find_root_discriminants(balls, 0, a.vertices.size(), a);
  worker.count(a);
  distribute_half_edges(worker.touching, {}, worker.patience(), a);
  a.first[own].half_edge = worker.counts.half_edges;
  a.first[own].closed_half_edge = worker.counts.closed;
  BlockSweep sweep(CubeBlock{{{0, balls.n}}, 1});
  worker.link(balls, sweep, boundary_, scratch_, a);
  a.first[own].loop = a.loop_count = worker.loops.last;
  a.first[own].face = a.face_count = worker.faces.last;
  return Status::ok;
}

}  // namespace hsp
