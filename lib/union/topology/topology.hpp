// The boundary with simple faces, its shells, and the regions of the complement. All ids of balls are in grid order;
// the memory is carved once for given limits. Vertices and edges are numbered by kind:
//
//   vertices   the boundary's | subdivision vertices | poles
//   edges      arcs, in the order of the half-edges on their first ball | circles | cut arcs | whole spheres
//
// Quarter-edge 4 e of an arc or circle has the face of the first of its balls in grid order on its left. Maximal faces
// and shells are those of class Boundary.
#pragma once

#include "boundary/boundary.hpp"
#include "core/limits.hpp"
#include "topology/cut_arcs.hpp"
#include "topology/quad_edges.hpp"
#include "topology/subdivision.hpp"

namespace hsp {

struct TopologyLimits {
  uint32_t balls = 0, neighbours = 0, edges = 0, cut_arcs = 0;
  uint32_t shells = 0;  // 0: as many as the edges allow

  // A shell has at least two edges.
  constexpr uint32_t most_shells() const { return shells == 0 || shells > edges / 2 ? edges / 2 : shells; }
  // Two poles for every whole sphere, which is a shell. At any other pole at least two cut arcs meet, and a cut arc
  // passes two poles at most.
  constexpr uint64_t most_poles() const {
    return no_more_than_edges(static_cast<uint64_t>(cut_arcs) + 2 * static_cast<uint64_t>(most_shells()));
  }
  // A face has at least two edges, and an edge has two faces: so there are no more faces than edges. If shells are few,
  // there are fewer: vertices - edges + faces is at most two for each shell. Free circles, whole spheres and
  // subdivision vertices add as many vertices as edges. Three arcs come with two vertices. The pieces of a cut arc,
  // three at most, may come with none. That leaves one face for every three edges, two for every cut arc and two for
  // every shell.
  constexpr uint64_t most_simple_faces() const {
    return no_more_than_edges(edges / 3 + 2 * static_cast<uint64_t>(cut_arcs) +
                              2 * static_cast<uint64_t>(most_shells()));
  }

 private:
  constexpr uint64_t no_more_than_edges(uint64_t wanted) const { return wanted < edges ? wanted : edges; }
};

// The limits that cover both. As 0 shells means no limit, it covers all others.
constexpr TopologyLimits covering(const TopologyLimits &limits, const TopologyLimits &others) {
  TopologyLimits both = each_limit(limits, others, larger_count);
  if (limits.shells == 0) both.shells = 0;
  return both;
}

// The highest or lowest point of a ball.
class Pole {
 public:
  Pole() = default;
  constexpr Pole(uint32_t ball, bool lowest) : code_(2 * ball + (lowest ? 1U : 0U)) {}

  constexpr uint32_t ball() const { return code_ / 2; }
  constexpr bool is_lowest() const { return code_ % 2 != 0; }

 private:
  uint32_t code_;
};

enum class VertexKind : uint8_t { boundary_vertex, subdivision_vertex, pole };
enum class EdgeKind : uint8_t { arc, circle, cut_arc, whole_sphere };

struct SimpleFace {
  uint32_t face;  // the maximal face
  uint32_t q;     // an even quarter-edge with this face on its left
  uint32_t edges;
};

struct ShellRecord {
  uint32_t component;
  uint32_t region;
  bool is_void;
  uint32_t faces, simple_faces, edges, vertices;
  uint32_t start_face;       // the simple face where its traversal starts
  uint32_t first_traversed;  // where its part of Topology::traversal starts

  int32_t euler() const { return static_cast<int32_t>(vertices - edges + simple_faces); }
  uint32_t genus() const { return static_cast<uint32_t>(1 - euler() / 2); }
};

struct ComponentRecord {
  uint32_t balls;
  uint32_t top_ball;
  uint32_t outer_shell;
  uint32_t shells;
  uint32_t region;
  uint32_t above;  // the component that a ray from its highest point enters from outside, or no_id
};

struct Topology {
  FixedVector<CutArc> cut_arcs;
  Subdivision subdivision;

  QuadEdges quads;
  uint32_t first_circle_edge = 0, first_cut_edge = 0, first_sphere_edge = 0;
  // [2 edges] While the structure is built: the first subdivision vertices of host edges, which are half-edges and half
  // circles, two or fewer for each edge. Afterwards: `traversal` and `marks`.
  Span<uint32_t> shared;
  Span<uint32_t> chain;           // [2 edges] by half-edge or half circle: chain_start(), and chain_is_cut() in bit 0
  Span<uint32_t> cut_first_edge;  // [cut arcs] the first edge of each
  Span<uint32_t> edge_source;     // [edges] number of the arc, half circle or cut arc, or ball of the whole sphere
  Span<uint32_t> host_of_arc;     // [arcs] the half-edge on its first ball

  uint32_t first_pole = 0;  // vertex ids from here on are poles
  uint32_t vertex_count = 0;
  Span<uint32_t> vertex_edge;  // [vertices] a quarter-edge that starts there
  Span<Pole> pole;             // [poles]

  Span<SimpleFace> faces;
  uint32_t face_count = 0;

  Span<ShellRecord> shells;
  Span<uint32_t> traversal;          // [simple faces] in `shared`: shell by shell, in the order of the traversal
  Span<uint32_t> marks;              // [edges] in `shared`: scratch memory
  Span<ComponentRecord> components;  // each has an outer shell
  uint32_t shell_count = 0;
  uint32_t component_count = 0;
  uint32_t region_count = 0;
  int64_t highest_centre = 0;   // largest z of all balls
  uint32_t start_face = no_id;  // the simple face that holds the highest point of the union

  void carve(Workspace &workspace, const TopologyLimits &limits);

  // The host of an edge that is part of an arc or circle.
  uint32_t host_of_edge(uint32_t edge) const {
    return edge < first_circle_edge ? host_of_arc[edge_source[edge]] : edge_source[edge];
  }
  // The edges of a host have consecutive numbers. They are its chain: for a half-edge in its own direction, for a half
  // circle in the direction of the loop on the first ball.
  uint32_t chain_start(uint32_t host) const { return chain[host] & ~1U; }
  bool chain_is_cut(uint32_t host) const { return (chain[host] & 1U) != 0; }
  uint32_t chain_end(uint32_t host) const {
    uint32_t q = chain_start(host);
    if (!chain_is_cut(host)) return q;
    const uint32_t source = edge_source[edge_of(q)];
    const uint32_t step = (q & 2U) == 0 ? 4U : 0U - 4U;
    while (edge_of(q + step) < first_cut_edge && edge_source[edge_of(q + step)] == source) q += step;
    return q;
  }
  // The first quarter-edge of a loop on its own ball. Its left face is the first of the simple faces at this loop
  // (SimpleFaceBuilder numbers them loop by loop).
  uint32_t start_of_loop(const Boundary &boundary, uint32_t loop) const {
    const LoopElement start = boundary.loop_start(loop);
    if (!start.is_circle()) return chain_start(start.half_edge());
    const uint32_t circle = start.closed_half_edge().circle();
    if (start.closed_half_edge().side() == 0) return chain_start(Subdivision::half_circle(boundary, circle, 0));
    // Backwards from the end of the circle's edges, where the edges of the next circle begin.
    const uint32_t end = circle + 1 < boundary.circle_count()
                             ? edge_of(chain_start(Subdivision::half_circle(boundary, circle + 1, 0)))
                             : first_cut_edge;
    return sym(quarter_edge(end - 1));
  }
  VertexKind kind_of_vertex(const Boundary &boundary, uint32_t vertex) const {
    if (vertex < boundary.vertex_count()) return VertexKind::boundary_vertex;
    return vertex < first_pole ? VertexKind::subdivision_vertex : VertexKind::pole;
  }
  SubdivisionVertex subdivision_vertex(const Boundary &boundary, uint32_t vertex) const {
    return subdivision.vertex(boundary, vertex - boundary.vertex_count());
  }
  Pole pole_at(uint32_t vertex) const { return pole[vertex - first_pole]; }

  EdgeKind kind_of_edge(uint32_t edge) const {
    if (edge < first_circle_edge) return EdgeKind::arc;
    if (edge < first_cut_edge) return EdgeKind::circle;
    return edge < first_sphere_edge ? EdgeKind::cut_arc : EdgeKind::whole_sphere;
  }
  // Which part of its host edge or cut arc an edge is.
  uint32_t piece_of_host(uint32_t edge) const { return edge - edge_of(chain_start(host_of_edge(edge))); }
  uint32_t piece_of_cut_arc(uint32_t edge) const { return edge - cut_first_edge[edge_source[edge]]; }

  uint32_t ball_of(const Boundary &boundary, uint32_t simple_face) const {
    return boundary.face(faces[simple_face].face).ball;
  }
  uint32_t shell_of(const Boundary &boundary, uint32_t simple_face) const {
    return boundary.face(faces[simple_face].face).shell;
  }
};

}  // namespace hsp
