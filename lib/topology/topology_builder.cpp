#include "topology/topology_builder.hpp"

#include "topology/traversal.hpp"
#include "topology/simple_faces.hpp"

namespace hsp {

void TopologyStructure::carve(Workspace &workspace, const TopologyLimits &limits) {
  const uint64_t edges = limits.edges;
  extra_arcs = FixedVector<ExtraArc>(workspace.take<ExtraArc>(limits.extra_arcs));
  split_points.carve(workspace, limits.edges, limits.extra_arcs);
  quads.place(workspace.take<uint32_t>(QuadEdges::numbers_per_edge * edges));
  walk_start = workspace.take<uint32_t>(2 * edges);
  extra_first_edge = workspace.take<uint32_t>(limits.extra_arcs);
  edge_source = workspace.take<uint32_t>(edges);
  carrier_of_arc = workspace.take<uint32_t>(edges);
  // Every vertex starts at least two edges, every simple face has at least two, and a shell is no less than two edges.
  vertex_edge = workspace.take<uint32_t>(edges);
  pole = workspace.take<uint32_t>(edges);
  faces = workspace.take<SimpleFace>(edges);
  shells = workspace.take<ShellRecord>(edges / 2);
  scan = workspace.take<uint32_t>(edges);
  component = workspace.take<uint32_t>(limits.balls);
  components = workspace.take<ComponentRecord>(limits.balls);
}

void TopologyBuilder::carve(Workspace &workspace, const TopologyLimits &limits) {
  limits_ = limits;
  needed_ = {};
  structure_.carve(workspace, limits);
  finder_.carve(workspace, limits.neighbours, limits.edges);
  gathered_.carve(workspace, limits.neighbours);
  marks_ = workspace.take<uint32_t>(limits.edges);
}

Status TopologyBuilder::build(const CubeGrid &grid, const BoundaryStructure &boundary, uint32_t neighbours) {
  const BallSet &balls = grid.balls();
  const auto clamp = [](uint64_t wanted) { return wanted < no_id ? static_cast<uint32_t>(wanted) : no_id; };
  needed_ = {balls.n, neighbours, clamp(count_uncut_edges(balls, boundary)), 0};
  const bool fits = needed_.balls <= limits_.balls && needed_.neighbours <= limits_.neighbours;
  if (!fits || needed_.edges > limits_.edges) return Status::capacity;

  finder_.find(grid, boundary, gathered_, structure_.extra_arcs);
  needed_.extra_arcs = clamp(structure_.extra_arcs.wanted());
  if (structure_.extra_arcs.overflowed()) {
    needed_.edges = 0;
    return Status::capacity;
  }
  structure_.split_points.insert(balls, boundary, structure_.extra_arcs.items());
  needed_.edges = clamp(count_edges(balls, boundary, structure_));
  if (needed_.edges > limits_.edges) return Status::capacity;

  assemble_simple_faces(balls, boundary, structure_);
  gather_components(grid, boundary, structure_);
  gather_cells(grid, boundary, structure_, gathered_);
  scan_shells(boundary, structure_, marks_);
  return Status::ok;
}

}  // namespace hsp
