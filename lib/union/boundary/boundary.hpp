// The boundary of a union: on every ball its half-edges, chained to loops, gathered to faces, joined to shells.
//
//   ball --half_edges--> half-edge --next--> ... = one loop
//        --circles-----> closed half-edge       = a loop on its own
//        --loops-------> loop --face--> face --shell--> shell
//
// All ids of balls are in grid order. Readers use the accessors of class Boundary; only the files of this room that
// build a boundary know its arrays.
//
// As an example the balls of radius 5 at (0,0,0), (6,0,0) and (0,6,0). All three spheres meet in (3, 3, +-2.65), and
// nothing else covers these points:
//   vertices 2     arcs 3, one for each pair of balls     half-edges 6, two on each ball
//   loops 3        faces 3, one on each ball              shells 1      components 1      voids 0
// Euler's relation: vertices - arcs + 2 faces - loops = 2 - 3 + 6 - 3 = 2, that of one sphere.
#pragma once

#include <cstdint>

#include "core/disjoint_sets.hpp"
#include "core/fixed_vector.hpp"
#include "core/id_range.hpp"
#include "core/limits.hpp"
#include "core/workspace.hpp"
#include "model/cube_grid.hpp"
#include "sphere/half_edges.hpp"

namespace hsp {

struct BoundaryLimits {
  uint32_t balls = 0, neighbours = 0, vertices = 0, circles = 0;
  uint32_t workers = 0;  // how many workers may share the work; 0 means 1
  // A loop has at least two arcs or is a circle.
  uint64_t most_loops() const { return 3 * static_cast<uint64_t>(vertices) / 2 + 2 * static_cast<uint64_t>(circles); }
};

// Limits that suffice for most molecules. Status::range if one would be larger than max_count.
constexpr Status default_limits(uint32_t balls, BoundaryLimits &limits) {
  if (balls > (max_count - 64) / 8) return Status::range;
  limits = {balls, balls < 256 ? balls : 256, 8 * balls + 64, 2 * balls + 16, 0};
  return Status::ok;
}

// A whole free circle as the loop that it makes on one of its two balls.
class ClosedHalfEdge {
 public:
  ClosedHalfEdge() = default;
  constexpr ClosedHalfEdge(uint32_t circle, uint32_t side) : id_(2 * circle + side) {}
  static constexpr ClosedHalfEdge from_id(uint32_t id) { return {id / 2, id % 2}; }

  constexpr uint32_t id() const { return id_; }
  constexpr uint32_t circle() const { return id_ / 2; }
  constexpr uint32_t side() const { return id_ % 2; }

 private:
  uint32_t id_;
};

// An element of a loop: a half-edge, or a whole circle.
class LoopElement {
 public:
  LoopElement() = default;
  static constexpr LoopElement arc(uint32_t half_edge) { return LoopElement(half_edge); }
  static constexpr LoopElement circle(ClosedHalfEdge e) { return LoopElement(circle_bit | e.id()); }
  static constexpr LoopElement from_code(uint32_t code) { return LoopElement(code); }
  constexpr bool operator==(const LoopElement &other) const = default;

  constexpr bool is_circle() const { return (code_ & circle_bit) != 0; }
  constexpr uint32_t code() const { return code_; }
  constexpr uint32_t half_edge() const { return code_; }  // if it is no circle
  constexpr ClosedHalfEdge closed_half_edge() const { return ClosedHalfEdge::from_id(code_ & ~circle_bit); }

 private:
  explicit constexpr LoopElement(uint32_t code) : code_(code) {}
  static constexpr uint32_t circle_bit = UINT32_C(1) << 31;
  uint32_t code_;
};

struct FaceRecord {
  uint32_t ball;
  uint32_t first_loop;  // the loops of a face are consecutive, and those of the next face follow
  uint32_t shell;
};

// The first half-edge, closed half-edge, loop and face of a ball. Those of the next ball follow. They are one record,
// since callers that read one of them read most of them.
struct FirstParts {
  uint32_t half_edge, closed_half_edge, loop, face;
};

// The memory of a boundary, carved once for given limits.
struct BoundaryArrays {
  FixedVector<VertexRecord> vertices;
  FixedVector<CircleRecord> circles;
  Span<double> root_discriminant;  // [vertices] sqrt(D), where the exact D is rounded once

  Span<FirstParts> first;                 // [balls + 1]
  Span<HalfEdge> half_edges;              // [3 vertices] by ball, and on each ball by the rank of the circle's ball
  Span<uint32_t> half_edge_at;            // [3 vertices] at 3 v + t: which starts at vertex v on its ball number t
  Span<ClosedHalfEdge> closed_half_edge;  // [2 circles] by ball, and on each ball by the rank of the other ball

  Span<LoopElement> loop_start;  // [loops]
  Span<uint32_t> loop_face;      // [loops]
  Span<FaceRecord> faces;        // [loops + balls]
  uint32_t balls = 0;
  uint32_t loop_count = 0;
  uint32_t face_count = 0;
  uint32_t shell_count = 0;
  uint32_t component_count = 0;

  // [balls] The bits contained and without_caps; above them the number of clusters of the ball's caps, 0 if they are
  // not counted, in units of one_cluster. Or left_out.
  Span<uint8_t> ball_state;
  static constexpr uint8_t contained = 1;
  static constexpr uint8_t without_caps = 2;  // no other sphere meets it: free as a whole unless it is contained
  static constexpr uint32_t one_cluster = 4;
  static constexpr uint8_t left_out = 252;  // it covers other balls, but nothing on its own sphere is looked for

  Span<uint32_t> component_origin;  // [balls] the ball of lowest rank in the ball's component
  Span<uint32_t> component;         // [balls] number of the ball's component

  Target target = Target::baseline;  // whose kernels are used

  void carve(Workspace &workspace, const BoundaryLimits &limits);
};

class Boundary {
 public:
  uint32_t ball_count() const { return a_.balls; }
  uint32_t vertex_count() const { return a_.vertices.size(); }
  uint32_t circle_count() const { return a_.circles.size(); }
  // Every arc is two half-edges, one on each of its balls, and three half-edges start at every vertex.
  uint32_t half_edge_count() const { return 3 * vertex_count(); }
  uint32_t arc_count() const { return half_edge_count() / 2; }
  uint32_t loop_count() const { return a_.loop_count; }
  uint32_t face_count() const { return a_.face_count; }
  uint32_t shell_count() const { return a_.shell_count; }
  uint32_t component_count() const { return a_.component_count; }
  // V - E + sum over faces of (2 - loops): the Euler characteristics of all shells.
  int64_t euler() const {
    return static_cast<int64_t>(vertex_count()) - arc_count() + 2 * static_cast<int64_t>(face_count()) - loop_count();
  }

  // The parts of one ball; their numbers are consecutive.
  IdRange half_edges(uint32_t ball) const { return range(&FirstParts::half_edge, ball); }
  IdRange loops(uint32_t ball) const { return range(&FirstParts::loop, ball); }
  IdRange faces(uint32_t ball) const { return range(&FirstParts::face, ball); }
  Span<const ClosedHalfEdge> circles(uint32_t ball) const {
    const IdRange ids = range(&FirstParts::closed_half_edge, ball);
    return a_.closed_half_edge.part(ids.first, ids.last);
  }
  bool is_contained(uint32_t ball) const { return (a_.ball_state[ball] & BoundaryArrays::contained) != 0; }
  // Whether the ball is not among the selected ones: nothing is known of its part of the boundary.
  bool is_left_out(uint32_t ball) const { return a_.ball_state[ball] == BoundaryArrays::left_out; }
  // Whether no other sphere meets the ball, and no other ball contains it.
  bool is_free_of_caps(uint32_t ball) const { return a_.ball_state[ball] == BoundaryArrays::without_caps; }
  bool is_exposed(uint32_t ball) const { return !faces(ball).empty(); }
  bool is_whole_sphere(uint32_t ball) const { return is_exposed(ball) && loops(ball).empty(); }

  // Vertices.
  const VertexRecord &vertex(uint32_t v) const { return a_.vertices[v]; }
  double root_discriminant(uint32_t v) const { return a_.root_discriminant[v]; }
  // The half-edge that starts at vertex v on its ball number `slot`.
  uint32_t half_edge_at(uint32_t v, uint32_t slot) const { return a_.half_edge_at[3 * v + slot]; }

  // Half-edges.
  const HalfEdge &half_edge(uint32_t e) const { return a_.half_edges[e]; }
  const HalfEdge *half_edge_data() const { return a_.half_edges.data(); }
  const double *root_discriminant_data() const { return a_.root_discriminant.data(); }
  // The circle of the half-edge that ends where this one starts: the circle of the vertex's third ball.
  uint32_t previous_circle(uint32_t ball, const HalfEdge &half_edge) const {
    const VertexRecord &start = vertex(half_edge.vertex);
    return start.ball[0] ^ start.ball[1] ^ start.ball[2] ^ ball ^ half_edge.circle;
  }
  uint32_t end_vertex(uint32_t e) const { return half_edge(half_edge(e).next).vertex; }
  // The half-edge of the same arc on the other ball: it starts where this one ends.
  uint32_t twin(uint32_t e) const {
    const uint32_t end = end_vertex(e);
    return half_edge_at(end, vertex(end).slot_of(half_edge(e).circle));
  }
  uint32_t face_of(uint32_t e) const { return face_of_loop(half_edge(e).loop); }
  uint32_t ball_of(uint32_t e) const { return face(face_of(e)).ball; }

  // Whole circles.
  const CircleRecord &circle(uint32_t c) const { return a_.circles[c]; }
  uint32_t ball_of(ClosedHalfEdge e) const { return circle(e.circle()).ball[e.side()]; }
  uint32_t neighbour(ClosedHalfEdge e) const { return circle(e.circle()).ball[1 - e.side()]; }
  uint32_t loop_of(ClosedHalfEdge e) const { return circle(e.circle()).loop[e.side()]; }

  // Loops and faces.
  uint32_t loop_of(LoopElement e) const {
    return e.is_circle() ? loop_of(e.closed_half_edge()) : half_edge(e.half_edge()).loop;
  }
  uint32_t face_of(LoopElement e) const { return face_of_loop(loop_of(e)); }
  uint32_t ball_of(LoopElement e) const { return face(face_of(e)).ball; }
  // The other ball on whose sphere the element lies.
  uint32_t neighbour(LoopElement e) const {
    return e.is_circle() ? neighbour(e.closed_half_edge()) : half_edge(e.half_edge()).circle;
  }
  uint32_t face_of_loop(uint32_t loop) const { return a_.loop_face[loop]; }
  uint32_t shell_of_loop(uint32_t loop) const { return face(face_of_loop(loop)).shell; }
  // The first half-edge of the loop, or the circle that it consists of.
  LoopElement loop_start(uint32_t loop) const { return a_.loop_start[loop]; }
  const FaceRecord &face(uint32_t f) const { return a_.faces[f]; }
  // First the loops of half-edges, in the order of their first half-edges, then circles. A whole sphere has no loops.
  IdRange loops_of_face(uint32_t f) const {
    return {face(f).first_loop, f + 1 < a_.face_count ? face(f + 1).first_loop : a_.loop_count};
  }

  // The target whose kernels run.
  Target target() const { return a_.target; }

  // Components of the union, numbered in the order of their first ball in the input.
  uint32_t component(uint32_t ball) const { return a_.component[ball]; }
  // The ball of lowest rank in a ball's component.
  uint32_t component_origin(uint32_t ball) const { return a_.component_origin[ball]; }

  // Hints to the processor that records of a ball will be read soon.
  void prefetch_ranges(uint32_t ball) const {
    __builtin_prefetch(&a_.first[ball]);
    __builtin_prefetch(&a_.component_origin[ball]);
  }
  // Always inlined: g++ finds no effect in such a function, and leaves out calls of it.
  [[gnu::always_inline]] void prefetch_half_edges(uint32_t ball) const {
    // The half-edges of most balls are in three cache lines at most; a branch on how many would be mispredicted.
    // Addresses are integers, as lines may lie behind the last half-edge.
    constexpr uint32_t lines = 3, size_of_line = 64;
    const uintptr_t front = reinterpret_cast<uintptr_t>(a_.half_edges.data() + half_edges(ball).first);
    for (uint32_t k = 0; k < lines; ++k) __builtin_prefetch(reinterpret_cast<const void *>(front + k * size_of_line));
  }
  // The vertices where the ball's half-edges start. all_half_edges: how many half-edges there are in all; in a periodic
  // box these are fewer than three a vertex.
  [[gnu::always_inline]] void prefetch_vertices(uint32_t ball, uint32_t all_half_edges) const {
    visit_first_half_edges(
        ball, all_half_edges, [this](const HalfEdge &e) __attribute__((always_inline)) {
          __builtin_prefetch(&a_.root_discriminant[e.vertex]);
        });
  }
  // The half-edges that start at a vertex.
  [[gnu::always_inline]] void prefetch_half_edges_at(uint32_t v) const {
    for (uint32_t t = 0; t < 3; ++t) __builtin_prefetch(&a_.half_edges[half_edge_at(v, t)]);
  }
  // The balls along whose circles the ball's half-edges run.
  [[gnu::always_inline]] void prefetch_neighbours(const BallSet &balls, uint32_t ball, uint32_t all_half_edges) const {
    visit_first_half_edges(
        ball, all_half_edges, [&balls](const HalfEdge &e) __attribute__((always_inline)) { balls.prefetch(e.circle); });
  }

 private:
  friend class BoundaryBuilder;
  friend class BoundaryPart;

  IdRange range(uint32_t FirstParts::*part, uint32_t ball) const {
    return {a_.first[ball].*part, a_.first[ball + 1].*part};
  }

  // Visits eight half-edges, of which some may be the next ball's: the end of a loop over those of the ball alone would
  // be mispredicted. Visits none if fewer than eight are left.
  template <class Visit>
  [[gnu::always_inline]] void visit_first_half_edges(uint32_t ball, uint32_t all_half_edges, Visit visit) const {
    constexpr uint32_t most = 8;
    const uint32_t first = half_edges(ball).first;
    if (first + most > all_half_edges) return;
    for (uint32_t k = 0; k < most; ++k) visit(half_edge(first + k));
  }

  BoundaryArrays a_;
};

}  // namespace hsp
