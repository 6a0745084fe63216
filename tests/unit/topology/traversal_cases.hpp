// Traversals of small topologies, from any of their faces: the order of the visits is one of a depth-first search, and
// the parts of every shell are counted. One that leaves its shell or ends early is refused.
#pragma once

#include "small_topology.hpp"
#include "topology/traversal.hpp"

namespace cases {

inline bool share_an_edge(const hsp::Topology &topology, uint32_t face, uint32_t other) {
  for (uint32_t q = 0; q < 4 * topology.quads.edges; q += 2) {
    if (topology.quads.left(q) == face && topology.quads.left(hsp::sym(q)) == other) return true;
  }
  return false;
}

// Depth first: every face is a neighbour of the last one visited that had neighbours left.
inline bool is_depth_first(const hsp::Topology &topology, hsp::Span<const uint32_t> order) {
  bool visited[48] = {};
  uint32_t open[48], depth = 0;
  if (topology.face_count > 48) return false;
  const auto is_done = [&](uint32_t face) {
    for (uint32_t other = 0; other < topology.face_count; ++other) {
      if (!visited[other] && share_an_edge(topology, face, other)) return false;
    }
    return true;
  };
  for (uint32_t k = 0; k < order.size(); ++k) {
    while (depth > 0 && is_done(open[depth - 1])) --depth;
    if (visited[order[k]] || (depth == 0) != (k == 0)) return false;
    if (k > 0 && !share_an_edge(topology, open[depth - 1], order[k])) return false;
    visited[order[k]] = true;
    open[depth++] = order[k];
  }
  // Nothing is left.
  while (depth > 0 && is_done(open[depth - 1])) --depth;
  return depth == 0;
}

inline uint32_t shells_are_traversed_depth_first() {
  return first_failing_scene([](const Scene &c) {
    if (!small_topology().build(c.ball, c.n)) return false;
    const hsp::Boundary &boundary = small_topology().boundary();
    hsp::Topology &topology = small_topology().topology();
    for (uint32_t start = 0; start < topology.face_count; ++start) {
      topology.shells[topology.shell_of(boundary, start)].start_face = start;
      if (!hsp::traverse_shells(boundary, topology, small_topology().marks())) return false;
      uint32_t first = 0;
      for (uint32_t s = 0; s < topology.shell_count; ++s) {
        const hsp::ShellRecord &shell = topology.shells[s];
        const hsp::Span<const uint32_t> order = topology.traversal.part(first, first + shell.simple_faces);
        if (shell.first_traversed != first || order[0] != shell.start_face || !is_depth_first(topology, order)) {
          return false;
        }
        for (const uint32_t face : order) {
          if (topology.shell_of(boundary, face) != s) return false;
        }
        first += shell.simple_faces;
      }
      if (first != topology.face_count) return false;
    }
    return true;
  });
}

// Counted again from the edges: every vertex and face is at an edge.
inline uint32_t parts_of_shells_are_counted() {
  return first_failing_scene([](const Scene &c) {
    if (!small_topology().build(c.ball, c.n)) return false;
    const hsp::Boundary &boundary = small_topology().boundary();
    hsp::Topology &topology = small_topology().topology();
    const hsp::QuadEdges &quads = topology.quads;
    for (uint32_t s = 0; s < topology.shell_count; ++s) {
      hsp::ShellRecord &shell = topology.shells[s];
      shell.faces = shell.simple_faces = shell.edges = shell.vertices = 77;  // whatever was there before
    }
    if (!hsp::traverse_shells(boundary, topology, small_topology().marks())) return false;
    for (uint32_t s = 0; s < topology.shell_count; ++s) {
      bool face_there[48] = {}, simple_there[48] = {}, vertex_there[48] = {};
      uint32_t faces = 0, simple_faces = 0, edges = 0, vertices = 0;
      const auto count_once = [](bool &there, uint32_t &count) {
        count += there ? 0U : 1U;
        there = true;
      };
      for (uint32_t q = 0; q < 4 * quads.edges; q += 2) {
        const uint32_t left = quads.left(q);
        if (topology.shell_of(boundary, left) != s) continue;
        edges += q % 4 == 0 ? 1U : 0U;
        count_once(face_there[topology.faces[left].face], faces);
        count_once(simple_there[left], simple_faces);
        count_once(vertex_there[quads.origin(q)], vertices);
      }
      const hsp::ShellRecord &shell = topology.shells[s];
      if (shell.faces != faces || shell.simple_faces != simple_faces || shell.edges != edges ||
          shell.vertices != vertices) {
        return false;
      }
    }
    return true;
  });
}

// Two lenses apart. A face said to be of the other shell leaves its own with one face too few, the other with one too
// many; the faces across the edges are met all the same.
inline uint32_t other_shells_are_refused() {
  const SmallBall balls[] = {{0, 0, 0, 5}, {8, 0, 0, 5}, {100, 0, 0, 5}, {108, 0, 0, 5}};
  if (!small_topology().build(balls, 4)) return 0;
  const hsp::Boundary &boundary = small_topology().boundary();
  hsp::Topology &topology = small_topology().topology();
  hsp::BoundaryArrays &arrays = small_union().builder().arrays();
  const hsp::Span<uint32_t> marks = small_topology().marks();
  if (topology.shell_count != 2 || topology.face_count != 4) return 1;
  for (uint32_t face = 0; face < 4; ++face) {
    uint32_t &shell = arrays.faces[face].shell;
    shell = 1 - shell;
    if (hsp::traverse_shells(boundary, topology, marks)) return 2;
    shell = 1 - shell;
    if (!hsp::traverse_shells(boundary, topology, marks)) return 3;
  }
  // A face that is not counted.
  const uint32_t last = --topology.face_count;
  marks[last] = hsp::no_id;
  if (hsp::traverse_shells(boundary, topology, marks)) return 4;
  ++topology.face_count;
  return hsp::traverse_shells(boundary, topology, marks) ? all_hold : 5;
}

inline constexpr Check topology_traversal[] = {{"shells_are_traversed_depth_first", shells_are_traversed_depth_first},
                                               {"parts_of_shells_are_counted", parts_of_shells_are_counted},
                                               {"other_shells_are_refused", other_shells_are_refused}};

}  // namespace cases
