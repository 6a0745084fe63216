#include "boundary/boundary_check.hpp"

#include "boundary/half_edge_links.hpp"

namespace hsp {
namespace {

class StructureCheck {
 public:
  StructureCheck(const BallSet &balls, const BoundaryStructure &boundary) : balls_(balls), boundary_(boundary) {}

  Violation run() {
    if (!vertices() || !uses() || !successors() || !twins() || !loops() || !faces() || !shells() || !euler()) {
      return violation_;
    }
    return {};
  }

 private:
  bool fail(BoundaryLaw law, uint32_t where) {
    violation_ = {law, where};
    return false;
  }
  uint32_t use_count() const { return 3 * boundary_.vertices.size(); }

  // Three different balls in ascending order, none of them inside another.
  bool vertices() {
    for (uint32_t v = 0; v < boundary_.vertices.size(); ++v) {
      const uint32_t *ball = boundary_.vertices[v].ball;
      bool good = ball[0] < ball[1] && ball[1] < ball[2] && ball[2] < balls_.n;
      for (int t = 0; t < 3 && good; ++t) {
        good = (boundary_.ball_state[ball[t]] & BoundaryStructure::contained) == 0;
      }
      if (!good) return fail(BoundaryLaw::vertices, v);
    }
    return true;
  }

  // One use on each of a vertex's balls, between the other two, in the order that its sign gives.
  bool uses() {
    if (boundary_.first_use[balls_.n] != use_count()) return fail(BoundaryLaw::uses, 0);
    for (uint32_t v = 0; v < boundary_.vertices.size(); ++v) {
      const VertexRecord &vertex = boundary_.vertices[v];
      for (uint32_t t = 0; t < 3; ++t) {
        const uint32_t u = boundary_.use_at[3 * v + t];
        const uint32_t ball = vertex.ball[t];
        if (u < boundary_.first_use[ball] || u >= boundary_.first_use[ball + 1]) return fail(BoundaryLaw::uses, v);
        const VertexUse &use = boundary_.uses[u];
        const uint32_t following = vertex.ball[(t + 1) % 3];
        const uint32_t preceding = vertex.ball[(t + 2) % 3];
        const bool good = use.vertex == v && use.in == (vertex.positive() ? following : preceding) &&
                          use.out == (vertex.positive() ? preceding : following);
        if (!good) return fail(BoundaryLaw::uses, v);
      }
    }
    return true;
  }

  // The arc that leaves a use arrives on the same ball, along the same circle.
  bool successors() {
    for (uint32_t i = 0; i < balls_.n; ++i) {
      for (uint32_t u = boundary_.first_use[i]; u < boundary_.first_use[i + 1]; ++u) {
        const VertexUse &use = boundary_.uses[u];
        const bool good = use.next >= boundary_.first_use[i] && use.next < boundary_.first_use[i + 1] &&
                          boundary_.uses[use.next].in == use.out;
        if (!good) return fail(BoundaryLaw::successors, u);
      }
    }
    return true;
  }

  // The two walks of an arc: each starts where the other ends, on each other's balls, and the twin of the twin is the
  // first. So no two arcs arrive at one use, and the successors chain all uses to closed loops.
  bool twins() {
    for (uint32_t i = 0; i < balls_.n; ++i) {
      for (uint32_t u = boundary_.first_use[i]; u < boundary_.first_use[i + 1]; ++u) {
        const VertexUse &use = boundary_.uses[u];
        const uint32_t twin = twin_use(boundary_, u);
        const bool good =
            twin >= boundary_.first_use[use.out] && twin < boundary_.first_use[use.out + 1] &&
            boundary_.uses[twin].out == i && boundary_.uses[boundary_.uses[twin].next].vertex == use.vertex &&
            boundary_.uses[twin].vertex == boundary_.uses[use.next].vertex && twin_use(boundary_, twin) == u;
        if (!good) return fail(BoundaryLaw::twins, u);
      }
    }
    return true;
  }

  // Loops keep to one ball and to one number, and have at least two arcs.
  bool loops() {
    for (uint32_t i = 0; i < balls_.n; ++i) {
      const uint32_t first = boundary_.first_loop[i];
      const uint32_t last = boundary_.first_loop[i + 1];
      if (first > last || last > boundary_.loop_count) return fail(BoundaryLaw::loops, first);
      for (uint32_t u = boundary_.first_use[i]; u < boundary_.first_use[i + 1]; ++u) {
        const VertexUse &use = boundary_.uses[u];
        const bool good =
            use.loop >= first && use.loop < last && boundary_.uses[use.next].loop == use.loop && use.next != u;
        if (!good) return fail(BoundaryLaw::loops, use.loop);
      }
    }
    for (const CircleRecord &circle : boundary_.circles.items()) {
      for (uint32_t side = 0; side < 2; ++side) {
        const uint32_t ball = circle.ball[side];
        const uint32_t loop = circle.loop[side];
        const bool good = ball < balls_.n && loop >= boundary_.first_loop[ball] &&
                          loop < boundary_.first_loop[ball + 1] && boundary_.loop_cap[loop] == circle.ball[1 - side];
        if (!good) return fail(BoundaryLaw::loops, loop);
      }
    }
    return true;
  }

  // Every loop bounds a face of its own ball, faces count their loops, and only a whole sphere has none.
  bool faces() {
    const Span<uint32_t> counted = boundary_.face_parent;
    for (uint32_t f = 0; f < boundary_.face_count; ++f) counted[f] = 0;
    for (uint32_t i = 0; i < balls_.n; ++i) {
      const uint32_t first = boundary_.first_face[i];
      const uint32_t last = boundary_.first_face[i + 1];
      if (first > last || last > boundary_.face_count) return fail(BoundaryLaw::faces, first);
      for (uint32_t loop = boundary_.first_loop[i]; loop < boundary_.first_loop[i + 1]; ++loop) {
        const uint32_t face = boundary_.loop_face[loop];
        if (face < first || face >= last) return fail(BoundaryLaw::faces, face);
        ++counted[face];
      }
      for (uint32_t f = first; f < last; ++f) {
        const bool whole_sphere = boundary_.ball_state[i] == BoundaryStructure::without_caps;
        const bool good = boundary_.faces[f].ball == i && boundary_.faces[f].loops == counted[f] &&
                          (counted[f] > 0 || (whole_sphere && last - first == 1));
        if (!good) return fail(BoundaryLaw::faces, f);
      }
    }
    return boundary_.first_face[balls_.n] == boundary_.face_count || fail(BoundaryLaw::faces, boundary_.face_count);
  }

  // Faces on both sides of an arc or circle are of one shell, and shells are numbered without gaps by their first
  // faces.
  bool shells() {
    uint32_t seen = 0;
    for (uint32_t f = 0; f < boundary_.face_count; ++f) {
      const uint32_t shell = boundary_.faces[f].shell;
      if (shell > seen || shell >= boundary_.shell_count) return fail(BoundaryLaw::shells, f);
      if (shell == seen) ++seen;
    }
    if (seen != boundary_.shell_count) return fail(BoundaryLaw::shells, seen);
    for (uint32_t u = 0; u < use_count(); ++u) {
      if (shell_of_loop(boundary_.uses[u].loop) != shell_of_loop(boundary_.uses[twin_use(boundary_, u)].loop)) {
        return fail(BoundaryLaw::shells, boundary_.loop_face[boundary_.uses[u].loop]);
      }
    }
    for (const CircleRecord &circle : boundary_.circles.items()) {
      if (shell_of_loop(circle.loop[0]) != shell_of_loop(circle.loop[1])) {
        return fail(BoundaryLaw::shells, boundary_.loop_face[circle.loop[0]]);
      }
    }
    return true;
  }

  // Every shell is a closed orientable surface: its Euler characteristic is even and at most 2.
  bool euler() {
    // V - E + sum over faces of (2 - loops): a vertex has three uses and an arc two walks, each of which starts at a
    // use, so that a use counts 1/3 - 1/2. Six times that is an integer, kept modulo 2^32.
    const Span<uint32_t> six_times = boundary_.face_parent;
    for (uint32_t s = 0; s < boundary_.shell_count; ++s) six_times[s] = 0;
    for (uint32_t u = 0; u < use_count(); ++u) six_times[shell_of_loop(boundary_.uses[u].loop)] -= 1;
    for (uint32_t f = 0; f < boundary_.face_count; ++f) {
      six_times[boundary_.faces[f].shell] += 12 - 6 * boundary_.faces[f].loops;
    }
    for (uint32_t s = 0; s < boundary_.shell_count; ++s) {
      const int32_t value = static_cast<int32_t>(six_times[s]);
      if (value % 12 != 0 || value > 12) return fail(BoundaryLaw::euler, s);
    }
    // The shells of one component: one outside, the rest voids; so there are at least as many shells as components.
    uint32_t components = 0;
    for (uint32_t i = 0; i < balls_.n; ++i) components += boundary_.components.root(i) == i ? 1U : 0U;
    return boundary_.shell_count >= components || fail(BoundaryLaw::euler, components);
  }

  uint32_t shell_of_loop(uint32_t loop) const { return boundary_.faces[boundary_.loop_face[loop]].shell; }

  const BallSet &balls_;
  const BoundaryStructure &boundary_;
  Violation violation_;
};

}  // namespace

Violation check_structure(const BallSet &balls, const BoundaryStructure &boundary) {
  return StructureCheck(balls, boundary).run();
}

}  // namespace hsp
