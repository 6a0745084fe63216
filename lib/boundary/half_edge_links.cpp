#include "boundary/half_edge_links.hpp"

#include "core/sorting.hpp"
#include "sphere/half_edge_chain.hpp"

namespace hsp {
namespace {

// Starts of the parts of a counting sort from counts stored one slot later.
void accumulate(Span<uint32_t> first, uint32_t n) {
  for (uint32_t i = 0; i < n; ++i) first[i + 1] += first[i];
}
// After filling, the running starts are the ends of the parts: back by one.
void step_back(Span<uint32_t> first, uint32_t n) {
  for (uint32_t i = n; i > 0; --i) first[i] = first[i - 1];
  first[0] = 0;
}

// Every vertex starts a half-edge on each of its balls. On ball[0] of a positive vertex the loop arrives along the
// circle of ball[1] and leaves along that of ball[2]; the roles rotate cyclically over the three balls, and swap for a
// negative vertex.
void distribute_vertices(BoundaryArrays &a) {
  const Span<uint32_t> first = a.first_half_edge;
  for (uint32_t i = 0; i <= a.balls; ++i) first[i] = 0;
  for (const VertexRecord &vertex : a.vertices.items()) {
    for (const uint32_t ball : vertex.ball) ++first[ball + 1];
  }
  accumulate(first, a.balls);
  for (uint32_t v = 0; v < a.vertices.size(); ++v) {
    const VertexRecord &vertex = a.vertices[v];
    // Which of the other two comes first cannot be predicted: an index tells, not a branch.
    const uint32_t preceding = vertex.positive() ? 1 : 2;
    for (uint32_t t = 0; t < 3; ++t) {
      a.half_edges[first[vertex.ball[t]]++] = {v, vertex.ball[(t + preceding) % 3],
                                               vertex.ball[(t + 3 - preceding) % 3], no_id, no_id};
    }
  }
  step_back(first, a.balls);
}

void distribute_circles(BoundaryArrays &a) {
  const Span<uint32_t> first = a.first_closed_half_edge;
  for (uint32_t i = 0; i <= a.balls; ++i) first[i] = 0;
  for (const CircleRecord &circle : a.circles.items()) {
    for (const uint32_t ball : circle.ball) ++first[ball + 1];
  }
  accumulate(first, a.balls);
  for (uint32_t c = 0; c < a.circles.size(); ++c) {
    for (uint32_t side = 0; side < 2; ++side) {
      a.closed_half_edge[first[a.circles[c].ball[side]]++] = ClosedHalfEdge(c, side);
    }
  }
  step_back(first, a.balls);
}

// Sorts what lies on one ball by the ranks of the balls around it: sums over a ball's half-edges run in this order, so
// that neither ids nor the place of the set, on which the walls of cubes depend, have an effect on any bit.
void sort_half_edges(const BallSet &balls, Span<HalfEdge> half_edges, Span<ClosedHalfEdge> closed,
                     const BoundaryArrays &a) {
  sort_in_place(half_edges, [&balls](const HalfEdge &p, const HalfEdge &q) {
    return p.circle != q.circle ? balls.ranks_before(p.circle, q.circle)
                                : balls.ranks_before(p.previous_circle, q.previous_circle);
  });
  const auto neighbour = [&a](ClosedHalfEdge e) { return a.circles[e.circle()].ball[1 - e.side()]; };
  sort_in_place(closed, [&balls, &neighbour](ClosedHalfEdge p, ClosedHalfEdge q) {
    return balls.ranks_before(neighbour(p), neighbour(q));
  });
}

}  // namespace

void link_half_edges(const BallSet &balls, BoundaryArrays &a, Span<uint32_t> scratch) {
  distribute_vertices(a);
  distribute_circles(a);
  // The numbers of components are not known yet.
  const HalfEdgeChain chain(scratch.part(0, a.balls), a.component.part(0, a.balls));
  uint32_t loops = 0;
  for (uint32_t i = 0; i < a.balls; ++i) {
    const uint32_t first = a.first_half_edge[i];
    const uint32_t last = a.first_half_edge[i + 1];
    const Span<ClosedHalfEdge> closed =
        a.closed_half_edge.part(a.first_closed_half_edge[i], a.first_closed_half_edge[i + 1]);
    sort_half_edges(balls, a.half_edges.part(first, last), closed, a);
    for (uint32_t e = first; e < last; ++e) {
      const uint32_t v = a.half_edges[e].vertex;
      a.half_edge_at[3 * v + a.vertices[v].slot_of(i)] = e;
    }
    chain.link(a.half_edges.part(first, last), first, [&balls, i](uint32_t j) { return balls.exact_difference(i, j); });

    a.first_loop[i] = loops;
    for (uint32_t start = first; start < last; ++start) {
      if (a.half_edges[start].loop != no_id) continue;
      a.loop_start[loops] = LoopElement::arc(start);
      for (uint32_t e = start; a.half_edges[e].loop == no_id; e = a.half_edges[e].next) a.half_edges[e].loop = loops;
      ++loops;
    }
    for (const ClosedHalfEdge e : closed) {
      CircleRecord &circle = a.circles[e.circle()];
      circle.loop[e.side()] = loops;
      a.loop_start[loops++] = LoopElement::circle(e);
    }
  }
  a.first_loop[a.balls] = loops;
  a.loop_count = loops;
}

}  // namespace hsp
