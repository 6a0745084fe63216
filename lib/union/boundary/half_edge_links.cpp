// Sorts half-edges into rows, one for each ball, and chains each half-edge to the next one.
//
// As an example three balls whose spheres meet in vertices 0 and 1 (boundary.hpp). A half-edge starts at each vertex on
// each of its three balls, and a counting sort puts the six in order:
//   ball                    0         1         2
//   its half-edges        0   1     2   3     4   5
//   the vertex of each    0   1     0   1     0   1     half_edge_at[3 v + t]: 0 2 4 of vertex 0, 1 3 5 of vertex 1
// On ball 0 one half-edge, say that from vertex 0, leaves along the circle of ball 1. At vertex 1 the loop arrives
// along that circle, so the half-edge from vertex 1 is the next one. It leaves along the circle of ball 2, along which
// the loop arrives at vertex 0: both half-edges are one loop.
#include "boundary/half_edge_links.hpp"

#include "core/key_ranks.hpp"
#include "core/small_code.hpp"
#include "core/sorting.hpp"

namespace hsp {
namespace {

// Calls visit(side) for each side of a record on which a ball of the range lies. The balls of records ascend.
template <class Record, class Visit>
void for_sides_on(BallRange range, const Record &record, Visit visit) {
  constexpr uint32_t sides = sizeof record.ball / sizeof record.ball[0];
  if (!small_code && record.ball[0] >= range.first && record.ball[sides - 1] < range.last) {
    for (uint32_t side = 0; side < sides; ++side) visit(side);
    return;
  }
  for (uint32_t side = 0; side < sides; ++side) {
    if (record.ball[side] >= range.first && record.ball[side] < range.last) visit(side);
  }
}

// A counting sort of the sides of records by their balls, in two steps. After the first step first[i].*part is where
// the part of ball i ends, counted from the first ball of the range, and after the second step where it begins. This
// function counts the sides on each ball, for the first step.
template <uint32_t FirstParts::*part, class Record>
void count_sides(Span<const Record> records, BallRange range, Span<FirstParts> first, Patience &patience) {
  in_parts(patience, IdRange{0, records.size()}, 100, [&](IdRange some) {
    for (const uint32_t id : some) {
      const Record &record = records[id];
      for_sides_on(range, record, [&](uint32_t side) { ++(first[record.ball[side]].*part); });
    }
  });
}
// The second step: calls put(place, record, id, side) for each side. It is done in parts, between which it may be
// stopped; not all sides are put then.
template <uint32_t FirstParts::*part, class Record, class Put>
void distribute_sides(Span<const Record> records, IdRange ids, BallRange range, uint32_t before, Span<FirstParts> first,
                      Patience &patience, Put put) {
  for (uint32_t i = range.first; before != 0 && i < range.last; ++i) first[i].*part += before;
  // From the last record to the first one.
  in_parts(patience, ids, 100, [&](IdRange some) {
    for (uint32_t id = ids.last - (some.first - ids.first), end = ids.last - (some.last - ids.first); id-- > end;) {
      const Record &record = records[id];
      for_sides_on(range, record, [&](uint32_t side) { put(--(first[record.ball[side]].*part), record, id, side); });
    }
  });
}

// The circle along which the loop arrives, before half-edges are chained.
uint32_t arriving_circle(const HalfEdge &half_edge) {
  return half_edge.loop;
}

// Chains the half-edges of one ball and numbers its loops. Half-edges and circles of a ball are in the order of the
// ranks of the balls around it, and sums over them run in this order. So neither ids nor the position of the set, on
// which the walls of cubes depend, have an effect on any bit.
class BallLinker {
 public:
  BallLinker(const BallSet &balls, BoundaryArrays &a, const HalfEdgeChain &chain)
      : balls_(balls), a_(a), chain_(chain) {}

  // Chains the half-edges of ball i to loops, numbered from `loops` on. Returns the number after the last loop.
  uint32_t link(uint32_t i, uint32_t loops) {
    const uint32_t first = a_.first[i].half_edge;
    const Span<HalfEdge> half_edges = a_.half_edges.part(first, a_.first[i + 1].half_edge);
    const auto direction = [this, i](uint32_t j) { return balls_.exact_difference(i, j); };
    if (sort_by_x(i, half_edges)) {
      chain_.link_marked(half_edges, first, &HalfEdge::loop, direction);
      return number_circles(i, number_few(half_edges, first, loops));
    }
    sort_in_place(half_edges, [this](const HalfEdge &p, const HalfEdge &q) {
      return p.circle != q.circle ? balls_.ranks_before(p.circle, q.circle)
                                  : balls_.ranks_before(arriving_circle(p), arriving_circle(q));
    });
    for (uint32_t k = 0; k < half_edges.size(); ++k) a_.half_edge_at[half_edges[k].next] = first + k;
    chain_.link(half_edges, first, &HalfEdge::loop, direction);
    return number_circles(i, number_many(half_edges, first, loops));
  }

 private:
  // Sorts half-edges by the x of their circles' balls, with which ranks begin, and marks them. Keys are integers, as
  // differences of x are below 2^31. Returns false, with no half-edge marked, if there are many, or if two centres have
  // the same x, so that the order of ranks may be another.
  bool sort_by_x(uint32_t i, Span<HalfEdge> half_edges) {
    static_assert(most_counted_keys <= HalfEdgeChain::most);
    HalfEdge given[most_counted_keys];
    int64_t key[most_counted_keys], sorted_key[most_counted_keys];
    uint32_t rank[most_counted_keys];
    const uint32_t count = half_edges.size();
    if (count == 0 || count > most_counted_keys) return false;
    const double *const x = balls_.x.data();
    const double own = x[i];
    for (uint32_t k = 0; k < count; ++k) {
      given[k] = half_edges[k];
      key[k] = static_cast<int64_t>(x[given[k].circle] - own) * (INT64_C(1) << 32) +
               (static_cast<int64_t>(x[arriving_circle(given[k])] - own) + (INT64_C(1) << 31));
    }
    count_ranks_of(key, count, rank);
    const uint32_t first = a_.first[i].half_edge;
    uint32_t circles = 0, sum = 0;
    for (uint32_t k = 0; k < count; ++k) {
      const uint32_t to = rank[k];
      half_edges[to] = given[k];
      sorted_key[to] = key[k];
      a_.half_edge_at[given[k].next] = first + to;
      circles += chain_.mark(arriving_circle(given[k]), given[k].circle, to);
      sum += to;
    }
    // If two keys are equal, the sum of ranks is another. Else there must be as many different x as circles.
    uint32_t different = 1;
    if (2 * sum == count * (count - 1)) {
      for (uint32_t k = 1; k < count; ++k) {
        different += static_cast<uint32_t>(static_cast<uint64_t>(sorted_key[k - 1] ^ sorted_key[k]) >> 32 != 0);
      }
    }
    if (different == circles) return true;
    for (uint32_t k = 0; k < count; ++k) half_edges[k] = given[k];
    chain_.unmark(half_edges, &HalfEdge::loop);
    return false;
  }

  void count_ranks_of(const int64_t *key, uint32_t count, uint32_t *rank) const {
    count_ranks(a_.target, key, count, rank);
  }

  // Follows one half-edge after the other. The ends of loops cannot be predicted, so no branch depends on them.
  uint32_t number_few(Span<HalfEdge> half_edges, uint32_t first, uint32_t loops) {
    const uint32_t count = half_edges.size();
    uint32_t left = UINT32_MAX >> (32 - count);
    uint32_t start = 0;
    uint32_t at = 0;
    for (uint32_t k = 0; k < count; ++k) {
      a_.loop_start[loops] = LoopElement::arc(first + start);
      half_edges[at].loop = loops;
      left &= ~(UINT32_C(1) << at);
      const uint32_t next = half_edges[at].next - first;
      const uint32_t closed = static_cast<uint32_t>(next == start);
      loops += closed;
      start ^= (start ^ static_cast<uint32_t>(std::countr_zero(left))) & (0 - closed);
      at = next ^ ((next ^ start) & (0 - closed));
    }
    return loops;
  }

  uint32_t number_many(Span<HalfEdge> half_edges, uint32_t first, uint32_t loops) {
    for (HalfEdge &half_edge : half_edges) half_edge.loop = no_id;
    for (uint32_t start = 0; start < half_edges.size(); ++start) {
      if (half_edges[start].loop != no_id) continue;
      a_.loop_start[loops] = LoopElement::arc(first + start);
      for (uint32_t k = start; half_edges[k].loop == no_id; k = half_edges[k].next - first) half_edges[k].loop = loops;
      ++loops;
    }
    return loops;
  }

  uint32_t number_circles(uint32_t i, uint32_t loops) {
    const Span<ClosedHalfEdge> closed =
        a_.closed_half_edge.part(a_.first[i].closed_half_edge, a_.first[i + 1].closed_half_edge);
    const auto neighbour = [this](ClosedHalfEdge e) { return a_.circles[e.circle()].ball[1 - e.side()]; };
    sort_in_place(closed, [this, &neighbour](ClosedHalfEdge p, ClosedHalfEdge q) {
      return balls_.ranks_before(neighbour(p), neighbour(q));
    });
    for (const ClosedHalfEdge e : closed) {
      a_.circles[e.circle()].loop[e.side()] = loops;
      a_.loop_start[loops++] = LoopElement::circle(e);
    }
    return loops;
  }

  const BallSet &balls_;
  BoundaryArrays &a_;
  const HalfEdgeChain &chain_;
};

}  // namespace

HalfEdgeCounts count_half_edges(const TouchingRecords &touching, Patience &patience, BoundaryArrays &a) {
  const auto [range, v, c] = touching;
  const Span<const VertexRecord> vertices = a.vertices.items().part(v.first, v.last);
  const Span<const CircleRecord> circles = a.circles.items().part(c.first, c.last);
  for (FirstParts &first : a.first.part(range.first, range.last)) first.half_edge = first.closed_half_edge = 0;
  count_sides<&FirstParts::half_edge>(vertices, range, a.first, patience);
  count_sides<&FirstParts::closed_half_edge>(circles, range, a.first, patience);
  HalfEdgeCounts total;
  for (FirstParts &first : a.first.part(range.first, range.last)) {
    first.half_edge = total.half_edges += first.half_edge;
    first.closed_half_edge = total.closed += first.closed_half_edge;
  }
  return total;
}

void distribute_half_edges(const TouchingRecords &touching, HalfEdgeCounts before, Patience &patience,
                           BoundaryArrays &a) {
  // A half-edge starts at every vertex on each of its balls. On ball[0] of a positive vertex the loop arrives along the
  // circle of ball[1] and leaves along that of ball[2]; the roles rotate cyclically over the three balls, and swap for
  // a negative vertex. Until half-edges are chained, `next` is the index in half_edge_at where the half-edge's number
  // goes, and `loop` is the circle along which the loop arrives.
  distribute_sides<&FirstParts::half_edge, VertexRecord>(
      a.vertices.items(), touching.vertices, touching.balls, before.half_edges, a.first, patience,
      [&a](uint32_t to, const VertexRecord &vertex, uint32_t v, uint32_t t) {
        // The order of the other two cannot be predicted: so an index depends on it, not a branch.
        const uint32_t preceding = vertex.positive() ? 1 : 2;
        a.half_edges[to] = {v, vertex.ball[(t + 3 - preceding) % 3], 3 * v + t, vertex.ball[(t + preceding) % 3]};
      });
  distribute_sides<&FirstParts::closed_half_edge, CircleRecord>(
      a.circles.items(), touching.circles, touching.balls, before.closed, a.first, patience,
      [&a](uint32_t to, const CircleRecord &, uint32_t c, uint32_t side) {
        a.closed_half_edge[to] = ClosedHalfEdge(c, side);
      });
}

uint32_t link_half_edges(const BallSet &balls, BallRange range, const HalfEdgeChain &chain, uint32_t loops,
                         Patience &patience, BoundaryArrays &a) {
  BallLinker linker(balls, a, chain);
  const Span<FirstParts> first = a.first;
  const Span<const uint8_t> state = a.ball_state;
  for (uint32_t i = range.first;; ++i) {
    for (; i < range.last && state[i] == BoundaryArrays::left_out; ++i) first[i].loop = loops;
    if (i == range.last) return loops;
    first[i].loop = loops;
    if (!patience.allows(1000)) return loops;
    loops = linker.link(i, loops);
  }
}

}  // namespace hsp
