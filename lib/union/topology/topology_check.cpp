#include "topology/topology_check.hpp"

#include <initializer_list>

namespace hsp {
namespace {

class TopologyCheck : FirstViolation<TopologyInvariant> {
 public:
  TopologyCheck(const Boundary &boundary, const Topology &topology, Span<uint32_t> marks)
      : boundary_(boundary), topology_(topology), quads_(topology.quads), marks_(marks) {}

  TopologyViolation run() {
    if (algebra() && vertices() && faces() && sides() && euler() && traversal()) regions();
    return violation_;
  }

 private:
  // onext is a permutation that keeps origins, and turns about dual faces in the other direction: e Rot Onext Rot Onext
  // = e.
  bool algebra() {
    for (uint32_t q = 0; q < 4 * quads_.edges; ++q) {
      const uint32_t next = quads_.onext(q);
      const bool good = next / 4 < quads_.edges && (next & 1U) == (q & 1U) && quads_.origin(next) == quads_.origin(q) &&
                        quads_.onext(rot(quads_.onext(rot(q)))) == q;
      if (!good) return fail(TopologyInvariant::algebra, q);
    }
    return true;
  }

  // Even quarter-edges start at vertices, and those that start at one vertex are one ring.
  bool vertices() {
    for (uint32_t v = 0; v < topology_.vertex_count; ++v) marks_[v] = 0;
    for (uint32_t e = 0; e < quads_.edges; ++e) {
      for (const uint32_t q : {quarter_edge(e), sym(quarter_edge(e))}) {
        if (quads_.origin(q) >= topology_.vertex_count) return fail(TopologyInvariant::vertices, q);
        ++marks_[quads_.origin(q)];
      }
    }
    for (uint32_t v = 0; v < topology_.vertex_count; ++v) {
      const uint32_t q = topology_.vertex_edge[v];
      if (q / 4 >= quads_.edges || q % 2 != 0 || quads_.origin(q) != v) return fail(TopologyInvariant::vertices, v);
      uint32_t length = 0;
      uint32_t at = q;
      do {  // which ends, as onext is a permutation
        at = quads_.onext(at);
        ++length;
      } while (at != q);
      if (length != marks_[v]) return fail(TopologyInvariant::vertices, v);
    }
    return true;
  }

  // Every simple face is one ring of at least two edges, and no edge has it on both sides.
  bool faces() {
    uint64_t sides = 0;
    for (uint32_t f = 0; f < topology_.face_count; ++f) {
      const SimpleFace &face = topology_.faces[f];
      if (face.face >= boundary_.face_count() || face.q / 4 >= quads_.edges || face.edges < 2) {
        return fail(TopologyInvariant::faces, f);
      }
      uint32_t at = face.q;
      for (uint32_t k = 0; k < face.edges; ++k) {
        const bool good =
            quads_.left(at) == f && quads_.left(sym(at)) != f && quads_.left(sym(at)) < topology_.face_count;
        if (!good || (k > 0 && at == face.q)) return fail(TopologyInvariant::faces, f);
        at = quads_.lnext(at);
      }
      if (at != face.q) return fail(TopologyInvariant::faces, f);
      sides += face.edges;
    }
    if (sides != 2 * static_cast<uint64_t>(quads_.edges)) return fail(TopologyInvariant::faces, topology_.face_count);
    return true;
  }

  // The faces beside an arc or circle lie on its balls, those beside a cut edge in one face of one ball.
  bool sides() {
    for (uint32_t e = 0; e < quads_.edges; ++e) {
      const uint32_t left = quads_.left(quarter_edge(e));
      const uint32_t right = quads_.left(sym(quarter_edge(e)));
      bool good = true;
      if (e >= topology_.first_cut_edge) {
        good = topology_.faces[left].face == topology_.faces[right].face;
      } else {
        const HostBalls pair = balls_of_host(boundary_, topology_.host_of_edge(e));
        good = topology_.ball_of(boundary_, left) == pair.a && topology_.ball_of(boundary_, right) == pair.b;
      }
      if (!good) return fail(TopologyInvariant::sides, quarter_edge(e));
    }
    return true;
  }

  // With simple faces the Euler characteristic is V - E + F. With maximal faces it is V - E + sum of (2 - loops), where
  // V and E are the boundary's own vertices and arcs: a half-edge counts as a third of a vertex and half of an arc.
  bool euler() {
    const uint32_t half_edges = boundary_.half_edge_count();
    for (uint32_t s = 0; s < topology_.shell_count; ++s) marks_[s] = 0;
    for (uint32_t u = 0; u < half_edges; ++u) {
      marks_[boundary_.face(boundary_.face_of_loop(boundary_.half_edge(u).loop)).shell] -= 1;
    }
    for (uint32_t f = 0; f < boundary_.face_count(); ++f) {
      marks_[boundary_.face(f).shell] += 12 - 6 * boundary_.loops_of_face(f).size();
    }
    for (uint32_t s = 0; s < topology_.shell_count; ++s) {
      const ShellRecord &shell = topology_.shells[s];
      if (6 * (shell.vertices - shell.edges + shell.simple_faces) != marks_[s])
        return fail(TopologyInvariant::euler, s);
    }
    return true;
  }

  bool traversal() {
    for (uint32_t f = 0; f < topology_.face_count; ++f) marks_[f] = 0;
    for (uint32_t s = 0; s < topology_.shell_count; ++s) {
      const ShellRecord &shell = topology_.shells[s];
      if (shell.first_traversed + shell.simple_faces > topology_.face_count)
        return fail(TopologyInvariant::traversal, s);
      for (uint32_t k = 0; k < shell.simple_faces; ++k) {
        const uint32_t face = topology_.traversal[shell.first_traversed + k];
        const bool good =
            face < topology_.face_count && topology_.shell_of(boundary_, face) == s && marks_[face]++ == 0;
        if (!good || (k == 0 && face != shell.start_face)) return fail(TopologyInvariant::traversal, s);
      }
    }
    return true;
  }

  // Every component has one outer shell, and all its other shells are voids with regions of their own. From any
  // component the way outward, each time to the component around its region, ends in region 0.
  bool regions() {
    uint32_t voids = 0;
    for (uint32_t s = 0; s < topology_.shell_count; ++s) {
      const ShellRecord &shell = topology_.shells[s];
      if (shell.component >= topology_.component_count || shell.region >= topology_.region_count) {
        return fail(TopologyInvariant::regions, s);
      }
      const ComponentRecord &component = topology_.components[shell.component];
      const bool good =
          shell.is_void ? shell.region == ++voids : component.outer_shell == s && component.region == shell.region;
      if (!good) return fail(TopologyInvariant::regions, s);
    }
    if (voids + 1 != topology_.region_count || voids + topology_.component_count != topology_.shell_count) {
      return fail(TopologyInvariant::regions, topology_.shell_count);
    }
    // The component around each void.
    for (uint32_t s = 0; s < topology_.shell_count; ++s) {
      if (topology_.shells[s].is_void) marks_[topology_.shells[s].region] = topology_.shells[s].component;
    }
    for (uint32_t c = 0; c < topology_.component_count; ++c) {
      uint32_t region = topology_.components[c].region;
      uint32_t steps = 0;
      for (; region != 0 && steps < topology_.region_count; ++steps)
        region = topology_.components[marks_[region]].region;
      if (region != 0) return fail(TopologyInvariant::regions, c);
    }
    return true;
  }

  const Boundary &boundary_;
  const Topology &topology_;
  const QuadEdges &quads_;
  Span<uint32_t> marks_;
};

}  // namespace

TopologyViolation check_topology(const Boundary &boundary, const Topology &topology, Span<uint32_t> marks) {
  return TopologyCheck(boundary, topology, marks).run();
}

}  // namespace hsp
