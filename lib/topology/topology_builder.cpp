#include "topology/topology_builder.hpp"

#include "topology/simple_faces.hpp"
#include "topology/traversal.hpp"

namespace hsp {

TopologyLimits limits_for(const BallSet &balls, const Boundary &boundary, uint32_t neighbours) {
  // A face with several loops needs one cut arc less than it has loops, and gets up to four times as many from great
  // circles that cross it more than once.
  uint64_t cut_arcs = 0;
  for (uint32_t f = 0; f < boundary.face_count(); ++f) {
    const uint32_t loops = boundary.loops_of_face(f).size();
    if (loops > 1) cut_arcs += 4 * (static_cast<uint64_t>(loops) - 1);
  }
  const auto clamp = [](uint64_t wanted) { return wanted < max_count ? static_cast<uint32_t>(wanted) : max_count; };
  return {balls.n, neighbours, clamp(count_uncut_edges(balls, boundary) + 4 * cut_arcs), clamp(cut_arcs)};
}

void Topology::carve(Workspace &workspace, const TopologyLimits &limits) {
  const uint64_t edges = limits.edges;
  cut_arcs = FixedVector<CutArc>(workspace.take<CutArc>(limits.cut_arcs));
  subdivision.carve(workspace, limits.edges, limits.cut_arcs);
  quads.bind(workspace.take<uint32_t>(QuadEdges::numbers_per_edge * edges));
  chain = workspace.take<uint32_t>(2 * edges);
  cut_first_edge = workspace.take<uint32_t>(limits.cut_arcs);
  edge_source = workspace.take<uint32_t>(edges);
  host_of_arc = workspace.take<uint32_t>(edges);
  // Every vertex starts at least two edges, every simple face has at least two, and a shell is no less than two edges.
  vertex_edge = workspace.take<uint32_t>(edges);
  pole = workspace.take<Pole>(edges);
  faces = workspace.take<SimpleFace>(edges);
  shells = workspace.take<ShellRecord>(edges / 2);
  traversal = workspace.take<uint32_t>(edges);
  components = workspace.take<ComponentRecord>(limits.balls);
}

void TopologyBuilder::carve(Workspace &workspace, const TopologyLimits &limits) {
  limits_ = limits;
  needed_ = {};
  structure_.carve(workspace, limits);
  finder_.carve(workspace, limits.neighbours);
  gathered_.carve(workspace, limits.neighbours);
  marks_ = workspace.take<uint32_t>(limits.edges);
}

Status TopologyBuilder::build(const CubeGrid &grid, const Boundary &boundary, uint32_t neighbours) {
  const BallSet &balls = grid.balls();
  scanned_ = false;
  needed_ = {balls.n, neighbours, clamped_count(count_uncut_edges(balls, boundary)), 0};
  const bool fits = needed_.balls <= limits_.balls && needed_.neighbours <= limits_.neighbours;
  if (!fits || needed_.edges > limits_.edges) return Status::capacity;

  // Quad-edges come later. Of the two loops or more of a face each has an edge at least, and an edge eight numbers.
  finder_.find(grid, boundary, gathered_, structure_.quads.memory, structure_.cut_arcs);
  needed_.cut_arcs = clamped_count(structure_.cut_arcs.required());
  if (structure_.cut_arcs.overflowed()) {
    needed_.edges = 0;
    return Status::capacity;
  }
  structure_.subdivision.insert(balls, boundary, structure_.cut_arcs.items());
  needed_.edges = clamped_count(count_edges(balls, boundary, structure_));
  if (needed_.edges > limits_.edges) return Status::capacity;

  assemble_simple_faces(balls, boundary, structure_);
  gather_components(grid, boundary, structure_);
  gather_cells(grid, boundary, structure_);
  return Status::ok;
}

const Topology &TopologyBuilder::scanned(const Boundary &boundary) {
  // Written once: afterwards several threads may read.
  if (!scanned_) {
    traverse_shells(boundary, structure_, marks_);
    scanned_ = true;
  }
  return structure_;
}

}  // namespace hsp
