// Quad-edges and simple faces of small unions: as many as are counted by hand, each a ring that knows its face, its
// sides on the right balls.
#pragma once

#include "small_topology.hpp"
#include "topology/simple_faces.hpp"

namespace cases {

inline uint32_t parts_are_counted() {
  return first_failing_scene([](const Scene &c) {
    if (!small_topology().build(c.ball, c.n)) return false;
    const hsp::Topology &topology = small_topology().topology();
    uint32_t with[7] = {};
    for (uint32_t face = 0; face < topology.face_count; ++face) {
      if (topology.faces[face].edges > 6) return false;
      ++with[topology.faces[face].edges];
    }
    return topology.vertex_count == c.cut.vertices && topology.quads.edges == c.cut.edges &&
           with[2] == c.cut.with_two && with[3] == c.cut.with_three && with[4] == c.cut.with_four &&
           with[6] == c.cut.with_six && topology.face_count == c.cut.faces();
  });
}

// How many edges there will be is known before they are made.
inline uint32_t edges_are_foretold() {
  return first_failing_scene([](const Scene &c) {
    if (!small_topology().build(c.ball, c.n)) return false;
    const hsp::Boundary &boundary = small_topology().boundary();
    const hsp::Topology &topology = small_topology().topology();
    uint32_t whole = 0;
    for (uint32_t ball = 0; ball < c.n; ++ball) whole += boundary.is_whole_sphere(ball) ? 1U : 0U;
    return hsp::count_edges(small_topology().balls(), boundary, topology) == c.cut.edges &&
           hsp::count_uncut_edges(small_topology().balls(), boundary) ==
               boundary.arc_count() + 2 * boundary.circle_count() + 2 * whole;
  });
}

// Every directed edge is on the ring of the face on its left, and starts where the one before it ends. Arcs and circles
// have the first of their balls on the left; other edges have two parts of one maximal face on their sides.
inline uint32_t rings_know_their_faces() {
  return first_failing_scene([](const Scene &c) {
    if (!small_topology().build(c.ball, c.n)) return false;
    const hsp::Boundary &boundary = small_topology().boundary();
    const hsp::Topology &topology = small_topology().topology();
    const hsp::QuadEdges &quads = topology.quads;
    uint32_t on_rings = 0;
    for (uint32_t face = 0; face < topology.face_count; ++face) {
      uint32_t q = topology.faces[face].q;
      for (uint32_t k = 0; k < topology.faces[face].edges; ++k, ++on_rings, q = quads.lnext(q)) {
        if (quads.left(q) != face || quads.left(hsp::sym(q)) == face) return false;
        if (quads.origin(quads.lnext(q)) != quads.origin(hsp::sym(q))) return false;
      }
      if (q != topology.faces[face].q) return false;
    }
    for (uint32_t edge = 0; edge < quads.edges; ++edge) {
      const uint32_t q = hsp::quarter_edge(edge);
      const uint32_t left = topology.ball_of(boundary, quads.left(q));
      const uint32_t right = topology.ball_of(boundary, quads.left(hsp::sym(q)));
      const bool between_balls = edge < topology.first_cut_edge;
      if (between_balls ? left >= right : left != right) return false;
      const uint32_t face = topology.faces[quads.left(q)].face;
      if (!between_balls && face != topology.faces[quads.left(hsp::sym(q))].face) return false;
    }
    for (uint32_t vertex = 0; vertex < topology.vertex_count; ++vertex) {
      if (quads.origin(topology.vertex_edge[vertex]) != vertex) return false;
    }
    return on_rings == 2 * quads.edges;
  });
}

// Bumps at azimuths 0 and 90 degrees. The lune between them has six edges, those beyond them have four: on the left of
// an edge down from the highest point lies what is further counter-clockwise, of an edge up from the lowest one what is
// less far.
struct LuneSide {
  bool from_lowest;
  uint32_t bump;  // 1 or 2
  uint32_t left_edges;
};
constexpr LuneSide lune_sides[] = {{false, 1, 6}, {false, 2, 4}, {true, 1, 4}, {true, 2, 6}};

inline uint32_t lunes_lie_in_order_about_poles() {
  return first_failing(lune_sides, [](const LuneSide &c) {
    const SmallBall balls[] = {{0, 0, 0, 100}, {100, 0, 0, 9}, {0, 100, 0, 9}};
    if (!small_topology().build(balls, 3)) return false;
    const hsp::Boundary &boundary = small_topology().boundary();
    const hsp::Topology &topology = small_topology().topology();
    const uint32_t bump = small_topology().grid().grid_index(c.bump);
    uint32_t found = 0;
    for (uint32_t q = 0; q < 4 * topology.quads.edges; q += 2) {
      const uint32_t from = topology.quads.origin(q);
      const uint32_t to = topology.quads.origin(hsp::sym(q));
      if (topology.kind_of_vertex(boundary, from) != hsp::VertexKind::pole ||
          topology.kind_of_vertex(boundary, to) != hsp::VertexKind::subdivision_vertex ||
          topology.pole_at(from).is_lowest() != c.from_lowest) {
        continue;
      }
      const hsp::HostBalls pair = hsp::balls_of_host(boundary, topology.subdivision_vertex(boundary, to).host);
      if (pair.a != bump && pair.b != bump) continue;
      if (topology.faces[topology.quads.left(q)].edges != c.left_edges) return false;
      ++found;
    }
    return found == 1;
  });
}

inline constexpr Check topology_simple_faces[] = {{"parts_are_counted", parts_are_counted},
                                                  {"edges_are_foretold", edges_are_foretold},
                                                  {"rings_know_their_faces", rings_know_their_faces},
                                                  {"lunes_lie_in_order_about_poles", lunes_lie_in_order_about_poles}};

}  // namespace cases
