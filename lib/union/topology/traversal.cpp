// Visits all faces of each shell, depth first, without a stack.
//
// As an example a tetrahedron with faces A to D, each next to the three others, traversed from A. The walk goes from A
// across its first edge to B, from B across the edge after the one that leads back to A, to C, and from C to D. All
// neighbours of D have been entered, so that the walk goes around D and back across its entry to C, and so on to B and
// A. The order is A B C D.
#include "topology/traversal.hpp"

namespace hsp {
namespace {

void tally_shells(const Boundary &boundary, Patience &patience, Topology &topology) {
  for (uint32_t s = 0; s < topology.shell_count; ++s) {
    ShellRecord &shell = topology.shells[s];
    shell.faces = shell.simple_faces = shell.edges = shell.vertices = 0;
  }
  for (uint32_t f = 0; f < boundary.face_count(); ++f) ++topology.shells[boundary.face(f).shell].faces;
  if (!patience.allows(50 * uint64_t{boundary.face_count()})) return;
  for (uint32_t f = 0; f < topology.face_count; ++f) {
    ShellRecord &shell = topology.shells[topology.shell_of(boundary, f)];
    ++shell.simple_faces;
    shell.edges += topology.faces[f].edges;  // each twice
  }
  for (uint32_t s = 0; s < topology.shell_count; ++s) topology.shells[s].edges /= 2;
  if (!patience.allows(50 * uint64_t{topology.face_count})) return;
  in_parts(patience, IdRange{0, topology.vertex_count}, 20, [&](IdRange some) {
    for (const uint32_t v : some)
      ++topology.shells[topology.shell_of(boundary, topology.quads.left(topology.vertex_edge[v]))].vertices;
  });
}

// Depth first: walks around each face counter-clockwise, from the edge by which it was entered. Only that edge must be
// remembered of a face to come back from it, so that no stack is needed. Returns the number of faces visited.
uint32_t traverse_shell(const Topology &topology, uint32_t start, Span<uint32_t> order, Span<uint32_t> entered,
                        Patience &patience) {
  const QuadEdges &quads = topology.quads;
  uint32_t face = start;
  uint32_t entry = topology.faces[start].q;
  uint32_t at = entry;
  uint32_t visited = 0;
  // After so many faces `patience` is asked whether to go on.
  constexpr uint32_t of_a_part = 8192;
  const auto at_most_all = [&order](uint32_t faces) { return faces < order.size() ? faces : order.size(); };
  uint32_t pause = at_most_all(of_a_part);
  entered[start] = entry;
  order[visited++] = start;
  for (;;) {
    const uint32_t across = quads.left(sym(at));
    if (entered[across] == no_id) {
      if (visited == pause) {
        if (visited == order.size() || !patience.allows(200 * of_a_part)) return visited + 1;
        pause = at_most_all(pause + of_a_part);
      }
      face = across;
      at = entry = sym(at);
      entered[face] = entry;
      order[visited++] = face;
    }
    at = quads.lnext(at);
    while (at == entry) {  // once around: back to the face that this one was entered from
      if (face == start) return visited;
      face = quads.left(sym(entry));
      at = quads.lnext(sym(entry));
      entry = entered[face];
    }
  }
}

}  // namespace

bool traverse_shells(const Boundary &boundary, Topology &topology, Span<uint32_t> entered, Patience patience) {
  tally_shells(boundary, patience, topology);
  if (!patience.allows(50 * uint64_t{topology.vertex_count})) return false;
  for (uint32_t f = 0; f < topology.face_count; ++f) entered[f] = no_id;
  uint32_t first = 0;
  for (uint32_t s = 0; s < topology.shell_count; ++s) {
    ShellRecord &shell = topology.shells[s];
    if (!patience.allows(200 * uint64_t{shell.simple_faces})) return false;
    shell.first_traversed = first;
    first += shell.simple_faces;
    const uint32_t visited = traverse_shell(topology, shell.start_face,
                                            topology.traversal.part(shell.first_traversed, first), entered, patience);
    if (visited != shell.simple_faces) return false;
  }
  return true;
}

}  // namespace hsp
