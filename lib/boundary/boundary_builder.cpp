#include "boundary/boundary_builder.hpp"

#include "boundary/components.hpp"
#include "boundary/half_edge_links.hpp"
#include "boundary/shells.hpp"
#include "core/processor.hpp"
#include "exact/discriminant.hpp"
#include "model/block_sweep.hpp"

namespace hsp {

void BoundaryArrays::carve(Workspace &workspace, const BoundaryLimits &limits) {
  wide_code = has_avx2();
  const uint64_t n = limits.balls;
  const uint64_t v = limits.vertices;
  const uint64_t loops = limits.most_loops();
  vertices = FixedVector<VertexRecord>(workspace.take<VertexRecord>(v));
  circles = FixedVector<CircleRecord>(workspace.take<CircleRecord>(limits.circles));
  root_discriminant = workspace.take<double>(v);
  half_edges = workspace.take<HalfEdge>(3 * v);
  first_half_edge = workspace.take<uint32_t>(n + 1);
  half_edge_at = workspace.take<uint32_t>(3 * v);
  closed_half_edge = workspace.take<ClosedHalfEdge>(2 * static_cast<uint64_t>(limits.circles));
  first_closed_half_edge = workspace.take<uint32_t>(n + 1);
  first_loop = workspace.take<uint32_t>(n + 1);
  loop_start = workspace.take<LoopElement>(loops);
  loop_face = workspace.take<uint32_t>(loops);
  first_face = workspace.take<uint32_t>(n + 1);
  faces = workspace.take<FaceRecord>(loops + n);
  ball_state = workspace.take<uint8_t>(n);
  component_origin = workspace.take<uint32_t>(n);
  component = workspace.take<uint32_t>(n);
}

void BoundaryBuilder::carve(Workspace &workspace, const BoundaryLimits &limits) {
  limits_ = limits;
  needed_ = {};
  arrays().carve(workspace, limits);
  caps_.carve(workspace, limits.neighbours);
  finder_.carve(workspace, limits.neighbours);
  faces_.carve(workspace, limits.balls, limits.neighbours);
  scratch_ = workspace.take<uint32_t>(limits.most_loops() + limits.balls);
  lanes_.carve(workspace, limits.neighbours, scratch_);
}

// One pass over the balls, cube by cube, so that the block of neighbouring cubes is looked up once for all balls of a
// cube.
void BoundaryBuilder::find_vertices(const CubeGrid &grid) {
  const BallSet &balls = grid.balls();
  BoundaryArrays &a = arrays();
  a.vertices.clear();
  a.circles.clear();
  DisjointSets components(a.component_origin.part(0, balls.n));
  components.reset();
  needed_.neighbours = 0;
  BlockSweep sweep(grid);
  for (uint32_t cube = 0; cube < grid.cubes(); ++cube) {
    const CubeBlock &block = sweep.block_around(cube);
    const BallRange own = grid.balls_in(cube);
    const bool in_lanes = lanes_.start_cube(grid, cube, block);
    for (uint32_t i = own.first; i < own.last; ++i) {
      const bool by_lanes = in_lanes && lanes_.gather(balls, i, caps_, &components);
      if (!by_lanes) caps_.gather(balls, block, i, &components);
      a.ball_state[i] = static_cast<uint8_t>((caps_.contained ? BoundaryArrays::contained : 0) |
                                             (caps_.count == 0 ? BoundaryArrays::without_caps : 0));
      if (caps_.contained) continue;
      if (caps_.met > needed_.neighbours) needed_.neighbours = caps_.met;
      // Once a ball has more neighbours than there is room for, the rest is only counted.
      if (needed_.neighbours > limits_.neighbours) continue;
      if (by_lanes) {
        faces_.visit_caps(caps_, lanes_.find(balls, caps_, finder_, a.vertices, a.circles));
      } else {
        finder_.find(balls, caps_, a.vertices, a.circles);
        faces_.visit_caps(caps_, 0);
      }
    }
  }
}

void BoundaryBuilder::find_root_discriminants(const BallSet &balls) {
  BoundaryArrays &a = arrays();
  for (uint32_t v = 0; v < a.vertices.size(); ++v) {
    const VertexRecord &vertex = a.vertices[v];
    const exact::LatticeBall origin = balls.ball(vertex.ball[0]);
    a.root_discriminant[v] =
        std::sqrt(exact::discriminant(exact::sphere_of(origin), exact::plane_of(origin, balls.ball(vertex.ball[1])),
                                      exact::plane_of(origin, balls.ball(vertex.ball[2]))));
  }
}

Status BoundaryBuilder::build(const CubeGrid &grid) {
  const BallSet &balls = grid.balls();
  BoundaryArrays &a = arrays();
  needed_ = {};
  needed_.balls = balls.n;
  if (balls.n > limits_.balls) return Status::capacity;
  a.balls = balls.n;
  find_vertices(grid);
  if (needed_.neighbours > limits_.neighbours) return Status::capacity;
  needed_.vertices = clamped_count(a.vertices.required());
  needed_.circles = clamped_count(a.circles.required());
  if (a.vertices.overflowed() || a.circles.overflowed()) return Status::capacity;

  find_root_discriminants(balls);
  link_half_edges(balls, a, scratch_);
  faces_.find(grid, boundary_, a, caps_, scratch_);
  find_shells(boundary_, a, scratch_);
  number_components(grid, a);
  return Status::ok;
}

}  // namespace hsp
