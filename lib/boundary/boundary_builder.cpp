#include "boundary/boundary_builder.hpp"

#include "boundary/half_edge_links.hpp"

namespace hsp {
namespace {

// With few caps, as on van der Waals surfaces, most balls have several loops and counting the clusters at once is
// cheaper than gathering the caps again; with many caps few balls have several loops.
constexpr uint32_t few_caps = 16;

}  // namespace

void BoundaryStructure::carve(Workspace &workspace, const BoundaryLimits &limits) {
  const uint64_t n = limits.balls;
  const uint64_t v = limits.vertices;
  const uint64_t loops = most_loops(limits);
  vertices = FixedVector<VertexRecord>(workspace.take<VertexRecord>(v));
  circles = FixedVector<CircleRecord>(workspace.take<CircleRecord>(limits.circles));
  root_discriminant = workspace.take<double>(v);
  uses = workspace.take<VertexUse>(3 * v);
  first_use = workspace.take<uint32_t>(n + 1);
  use_at = workspace.take<uint32_t>(3 * v);
  circle_side = workspace.take<uint32_t>(2 * static_cast<uint64_t>(limits.circles));
  first_circle_side = workspace.take<uint32_t>(n + 1);
  first_loop = workspace.take<uint32_t>(n + 1);
  loop_cap = workspace.take<uint32_t>(loops);
  loop_face = workspace.take<uint32_t>(loops);
  first_face = workspace.take<uint32_t>(n + 1);
  faces = workspace.take<FaceRecord>(loops + n);
  ball_state = workspace.take<uint8_t>(n);
  cluster_count = workspace.take<uint8_t>(n);
  component_parent = workspace.take<uint32_t>(n);
  face_parent = workspace.take<uint32_t>(loops + n);
}

void BoundaryBuilder::carve(Workspace &workspace, const BoundaryLimits &limits) {
  limits_ = limits;
  needed_ = {};
  structure_.carve(workspace, limits);
  caps_.carve(workspace, limits.neighbours);
  finder_.carve(workspace, limits.neighbours);
  scratch_.carve(workspace, limits.neighbours);
}

// One pass over the balls, cube by cube, so that the block of neighbouring cubes is looked up once for all balls of a
// cube.
void BoundaryBuilder::find_vertices(const CubeGrid &grid) {
  const BallSet &balls = grid.balls();
  structure_.vertices.clear();
  structure_.circles.clear();
  structure_.components = DisjointSets(structure_.component_parent.part(0, balls.n));
  structure_.components.reset();
  needed_.neighbours = 0;
  for (uint32_t cube = 0; cube < grid.cubes(); ++cube) {
    const CubeBlock block = grid.block_around(grid.table().coordinates(cube));
    const BallRange own = grid.balls_in(cube);
    for (uint32_t i = own.first; i < own.last; ++i) {
      caps_.gather(balls, block, i, &structure_.components);
      structure_.ball_state[i] = static_cast<uint8_t>((caps_.contained ? BoundaryStructure::contained : 0) |
                                                      (caps_.count == 0 ? BoundaryStructure::without_caps : 0));
      if (caps_.contained) continue;
      if (caps_.met > needed_.neighbours) needed_.neighbours = caps_.met;
      // Once a ball has more neighbours than there is room for, the rest is only counted.
      if (needed_.neighbours > limits_.neighbours) continue;
      finder_.find(balls, caps_, structure_.vertices, structure_.circles);
      structure_.cluster_count[i] = caps_.count <= few_caps ? static_cast<uint8_t>(count_clusters(caps_, scratch_))
                                                            : BoundaryStructure::not_counted;
    }
  }
}

Status BoundaryBuilder::build(const CubeGrid &grid) {
  const BallSet &balls = grid.balls();
  needed_ = {};
  needed_.balls = balls.n;
  if (balls.n > limits_.balls) return Status::capacity;
  find_vertices(grid);
  if (needed_.neighbours > limits_.neighbours) return Status::capacity;
  const auto clamp = [](uint64_t wanted) { return wanted < no_id ? static_cast<uint32_t>(wanted) : no_id; };
  needed_.vertices = clamp(structure_.vertices.wanted());
  needed_.circles = clamp(structure_.circles.wanted());
  if (structure_.vertices.overflowed() || structure_.circles.overflowed()) return Status::capacity;

  for (uint32_t v = 0; v < structure_.vertices.size(); ++v) {
    const VertexRecord &vertex = structure_.vertices[v];
    const exact::LatticeBall origin = balls.ball(vertex.ball[0]);
    structure_.root_discriminant[v] = std::sqrt(
        exact::Exact::discriminant(exact::sphere_of(origin), exact::plane_of(origin, balls.ball(vertex.ball[1])),
                                   exact::plane_of(origin, balls.ball(vertex.ball[2]))));
  }
  assemble_loops(balls, structure_);
  gather_faces(grid, caps_, scratch_, structure_);
  return Status::ok;
}

}  // namespace hsp
