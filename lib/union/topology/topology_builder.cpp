#include "topology/topology_builder.hpp"

#include "topology/simple_faces.hpp"
#include "topology/traversal.hpp"

namespace hsp {

TopologyLimits limits_for(const BallSet &balls, const Boundary &boundary, uint32_t neighbours) {
  // A face with several loops needs one cut arc less than it has loops, and gets up to four times as many from great
  // circles that cross it more than once. Of thousands of loops each circle crosses more: 4,000, 16,000 and 64,000 in
  // a spiral, all close to each other, take 4.5, 5.7 and 7.4 times as many.
  constexpr uint32_t fewest = 4, bits_of_few = 7;
  uint64_t cut_arcs = 0;
  for (uint32_t f = 0; f < boundary.face_count(); ++f) {
    const uint32_t loops = boundary.loops_of_face(f).size();
    if (loops < 2) continue;
    const uint32_t bits = 32 - static_cast<uint32_t>(__builtin_clz(loops));
    cut_arcs += (loops - uint64_t{1}) * (bits < fewest + bits_of_few ? fewest : bits - bits_of_few);
  }
  const auto clamp = [](uint64_t wanted) { return wanted < max_count ? static_cast<uint32_t>(wanted) : max_count; };
  return {balls.n, neighbours, clamp(count_uncut_edges(balls, boundary) + 4 * cut_arcs), clamp(cut_arcs),
          boundary.shell_count()};
}

void Topology::carve(Workspace &workspace, const TopologyLimits &limits) {
  const uint64_t edges = limits.edges;
  cut_arcs = FixedVector<CutArc>(workspace.take<CutArc>(limits.cut_arcs));
  subdivision.carve(workspace, limits.cut_arcs);
  quads.bind(workspace.take<uint32_t>(QuadEdges::numbers_per_edge * edges));
  shared = workspace.take<uint32_t>(2 * edges);
  traversal = shared.part(0, shared.size() / 2);
  marks = shared.part(shared.size() / 2, shared.size());
  chain = workspace.take<uint32_t>(2 * edges);
  cut_first_edge = workspace.take<uint32_t>(limits.cut_arcs);
  edge_source = workspace.take<uint32_t>(edges);
  host_of_arc = workspace.take<uint32_t>(edges);
  vertex_edge = workspace.take<uint32_t>(edges);  // at least two edges meet at every vertex
  pole = workspace.take<Pole>(limits.most_poles());
  faces = workspace.take<SimpleFace>(limits.most_simple_faces());
  const uint32_t most_shells = limits.most_shells();
  shells = workspace.take<ShellRecord>(most_shells);
  components = workspace.take<ComponentRecord>(limits.balls < most_shells ? limits.balls : most_shells);
}

void TopologyBuilder::carve(Workspace &workspace, const TopologyLimits &limits) {
  limit(limits);
  structure_.carve(workspace, limits);
  finder_.carve(workspace, limits.neighbours);
  gathered_.carve(workspace, limits.neighbours);
}

Status TopologyBuilder::build(const CubeGrid &grid, const Boundary &boundary, uint32_t neighbours, Patience patience) {
  const BallSet &balls = grid.balls();
  needed_ = {balls.n, neighbours, clamped_count(count_uncut_edges(balls, boundary)), 0, boundary.shell_count()};
  const bool fits = needed_.balls <= limits_.balls && needed_.neighbours <= limits_.neighbours &&
                    (limits_.shells == 0 || needed_.shells <= limits_.shells);
  if (!fits || needed_.edges > limits_.edges) return Status::capacity;

  // The memory of quad-edges is scratch memory until they come. It suffices: each loop of a face has at least one edge,
  // an edge has eight numbers, and such a face has at least two loops.
  finder_.find(grid, boundary, gathered_, structure_.quads.memory, patience, structure_.cut_arcs);
  if (!patience.allows(0)) return Status::stopped;
  needed_.cut_arcs = clamped_count(structure_.cut_arcs.required());
  if (structure_.cut_arcs.overflowed()) {
    needed_.edges = 0;
    return Status::capacity;
  }
  structure_.subdivision.insert(balls, boundary, structure_.cut_arcs.items(), structure_.shared, patience);
  if (!patience.allows(0)) return Status::stopped;
  needed_.edges = clamped_count(count_edges(balls, boundary, structure_));
  if (needed_.edges > limits_.edges) return Status::capacity;

  if (!patience.allows(100 * uint64_t{needed_.edges})) return Status::stopped;
  assemble_simple_faces(balls, boundary, patience, structure_);
  if (!patience.allows(1000 * uint64_t{balls.n})) return Status::stopped;
  gather_components(grid, boundary, structure_);
  if (!gather_regions(grid, boundary, patience, structure_) || !patience.allows(1000 * uint64_t{balls.n}))
    return Status::stopped;
  traverse_shells(boundary, structure_, structure_.marks, patience);
  return patience.allows(0) ? Status::ok : Status::stopped;
}

}  // namespace hsp
