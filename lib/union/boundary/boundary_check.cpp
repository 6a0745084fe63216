#include "boundary/boundary_check.hpp"

namespace hsp {
namespace {

class BoundaryCheck : FirstViolation<BoundaryInvariant> {
 public:
  BoundaryCheck(const BallSet &balls, const Boundary &boundary, Span<uint32_t> scratch)
      : balls_(balls), boundary_(boundary), scratch_(scratch) {}

  BoundaryViolation run() {
    if (vertices() && half_edges() && successors() && twins() && loops() && faces() && shells()) euler();
    return violation_;
  }

 private:
  // Three different balls in ascending order, none of them inside another.
  bool vertices() {
    for (uint32_t v = 0; v < boundary_.vertex_count(); ++v) {
      const uint32_t *ball = boundary_.vertex(v).ball;
      bool good = ball[0] < ball[1] && ball[1] < ball[2] && ball[2] < balls_.n;
      for (int t = 0; t < 3 && good; ++t) {
        good = !boundary_.is_contained(ball[t]);
      }
      if (!good) return fail(BoundaryInvariant::vertices, v);
    }
    return true;
  }

  // One half-edge on each of a vertex's balls, between the other two, in the order that its sign gives.
  bool half_edges() {
    uint32_t count = 0;
    for (uint32_t i = 0; i < balls_.n; ++i) count += boundary_.half_edges(i).size();
    if (count != boundary_.half_edge_count()) return fail(BoundaryInvariant::half_edges, 0);
    for (uint32_t v = 0; v < boundary_.vertex_count(); ++v) {
      const VertexRecord &vertex = boundary_.vertex(v);
      for (uint32_t t = 0; t < 3; ++t) {
        const uint32_t u = boundary_.half_edge_at(v, t);
        const uint32_t ball = vertex.ball[t];
        if (!boundary_.half_edges(ball).contains(u)) return fail(BoundaryInvariant::half_edges, v);
        const HalfEdge &half_edge = boundary_.half_edge(u);
        const uint32_t following = vertex.ball[(t + 1) % 3];
        const uint32_t preceding = vertex.ball[(t + 2) % 3];
        const bool good = half_edge.vertex == v && half_edge.circle == (vertex.positive() ? preceding : following);
        if (!good) return fail(BoundaryInvariant::half_edges, v);
      }
    }
    return true;
  }

  // The successor of a half-edge is on the same ball and is preceded by the same circle.
  bool successors() {
    for (uint32_t i = 0; i < balls_.n; ++i) {
      for (const uint32_t u : boundary_.half_edges(i)) {
        const HalfEdge &half_edge = boundary_.half_edge(u);
        const bool good = boundary_.half_edges(i).contains(half_edge.next) &&
                          boundary_.previous_circle(i, boundary_.half_edge(half_edge.next)) == half_edge.circle;
        if (!good) return fail(BoundaryInvariant::successors, u);
      }
    }
    return true;
  }

  // Twins: each starts where the other ends. It follows from the checks of half-edges and successors that twins are on
  // each other's balls, and that the twin of a twin is the half-edge itself. So no two half-edges have one successor,
  // and the successors chain all half-edges to closed loops.
  bool twins() {
    for (uint32_t i = 0; i < balls_.n; ++i) {
      for (const uint32_t u : boundary_.half_edges(i)) {
        if (boundary_.end_vertex(boundary_.twin(u)) != boundary_.half_edge(u).vertex)
          return fail(BoundaryInvariant::twins, u);
      }
    }
    return true;
  }

  // The half-edges of a loop are on one ball and have one loop number, and a loop starts at its first half-edge. It
  // follows that a loop has at least two arcs: at a vertex the circle changes.
  bool loops() {
    for (uint32_t i = 0; i < balls_.n; ++i) {
      const IdRange loops = boundary_.loops(i);
      if (loops.first > loops.last || loops.last > boundary_.loop_count()) {
        return fail(BoundaryInvariant::loops, loops.first);
      }
      for (const uint32_t u : boundary_.half_edges(i)) {
        const HalfEdge &half_edge = boundary_.half_edge(u);
        const bool good = loops.contains(half_edge.loop) &&
                          boundary_.half_edge(half_edge.next).loop == half_edge.loop &&
                          starts_no_later(half_edge.loop, u);
        if (!good) return fail(BoundaryInvariant::loops, half_edge.loop);
      }
    }
    for (uint32_t c = 0; c < boundary_.circle_count(); ++c) {
      const CircleRecord &circle = boundary_.circle(c);
      for (uint32_t side = 0; side < 2; ++side) {
        const uint32_t ball = circle.ball[side];
        const uint32_t loop = circle.loop[side];
        const bool good = ball < balls_.n && boundary_.loops(ball).contains(loop) &&
                          boundary_.loop_start(loop) == LoopElement::circle({c, side});
        if (!good) return fail(BoundaryInvariant::loops, loop);
      }
    }
    return true;
  }

  // Every loop bounds a face of its own ball, the loops of a face are consecutive, and only a whole sphere has none.
  bool faces() {
    const uint32_t end = balls_.n > 0 ? boundary_.faces(balls_.n - 1).last : 0;
    if (end != boundary_.face_count()) return fail(BoundaryInvariant::faces, boundary_.face_count());
    uint32_t next = 0;
    for (uint32_t i = 0; i < balls_.n; ++i) {
      const IdRange faces = boundary_.faces(i);
      if (faces.first > faces.last || faces.last > boundary_.face_count()) {
        return fail(BoundaryInvariant::faces, faces.first);
      }
      for (const uint32_t f : faces) {
        const IdRange loops = boundary_.loops_of_face(f);
        const bool whole_sphere = boundary_.is_free_of_caps(i) && faces.size() == 1;
        const bool good = boundary_.face(f).ball == i && loops.first == next && loops.first <= loops.last &&
                          loops.last <= boundary_.loops(i).last && loops.empty() == whole_sphere;
        if (!good) return fail(BoundaryInvariant::faces, f);
        for (const uint32_t loop : loops) {
          if (boundary_.face_of_loop(loop) != f) return fail(BoundaryInvariant::faces, f);
        }
        next = loops.last;
      }
      if (next != boundary_.loops(i).last) return fail(BoundaryInvariant::faces, faces.last);
    }
    return true;
  }

  // Faces on both sides of an arc or circle are of one shell, and shells are numbered without gaps by their first
  // faces.
  bool shells() {
    uint32_t seen = 0;
    for (uint32_t f = 0; f < boundary_.face_count(); ++f) {
      const uint32_t shell = boundary_.face(f).shell;
      if (shell > seen || shell >= boundary_.shell_count()) return fail(BoundaryInvariant::shells, f);
      if (shell == seen) ++seen;
    }
    if (seen != boundary_.shell_count()) return fail(BoundaryInvariant::shells, seen);
    for (uint32_t u = 0; u < boundary_.half_edge_count(); ++u) {
      if (shell_of(u) != shell_of(boundary_.twin(u))) return fail(BoundaryInvariant::shells, boundary_.face_of(u));
    }
    for (uint32_t c = 0; c < boundary_.circle_count(); ++c) {
      const CircleRecord &circle = boundary_.circle(c);
      if (boundary_.shell_of_loop(circle.loop[0]) != boundary_.shell_of_loop(circle.loop[1])) {
        return fail(BoundaryInvariant::shells, boundary_.face_of_loop(circle.loop[0]));
      }
    }
    return true;
  }

  // Every shell is a closed orientable surface: its Euler characteristic is even and at most 2.
  bool euler() {
    // V - E + sum over faces of (2 - loops): three half-edges start at a vertex and an arc is two, so that a half-edge
    // counts 1/3 - 1/2. Six times the sum is an integer, computed modulo 2^32.
    const Span<uint32_t> six_times = scratch_;
    for (uint32_t s = 0; s < boundary_.shell_count(); ++s) six_times[s] = 0;
    for (uint32_t u = 0; u < boundary_.half_edge_count(); ++u) six_times[shell_of(u)] -= 1;
    for (uint32_t f = 0; f < boundary_.face_count(); ++f) {
      six_times[boundary_.face(f).shell] += 12 - 6 * boundary_.loops_of_face(f).size();
    }
    for (uint32_t s = 0; s < boundary_.shell_count(); ++s) {
      const int32_t value = static_cast<int32_t>(six_times[s]);
      if (value % 12 != 0 || value > 12) return fail(BoundaryInvariant::euler, s);
    }
    // The shells of one component: one outside, the rest voids; so there are at least as many shells as components.
    uint32_t components = 0;
    for (uint32_t i = 0; i < balls_.n; ++i) components += boundary_.component_origin(i) == i ? 1U : 0U;
    if (boundary_.shell_count() < components) return fail(BoundaryInvariant::euler, components);
    return true;
  }

  bool starts_no_later(uint32_t loop, uint32_t half_edge) const {
    const LoopElement start = boundary_.loop_start(loop);
    return !start.is_circle() && start.half_edge() <= half_edge && boundary_.half_edge(start.half_edge()).loop == loop;
  }
  uint32_t shell_of(uint32_t half_edge) const { return boundary_.face(boundary_.face_of(half_edge)).shell; }

  const BallSet &balls_;
  const Boundary &boundary_;
  Span<uint32_t> scratch_;
};

}  // namespace

BoundaryViolation check_boundary(const BallSet &balls, const Boundary &boundary, Span<uint32_t> scratch) {
  return BoundaryCheck(balls, boundary, scratch).run();
}

}  // namespace hsp
