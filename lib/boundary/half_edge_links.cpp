#include "boundary/half_edge_links.hpp"

#include "sphere/half_edges.hpp"
#include "core/sorting.hpp"

namespace hsp {
namespace {

// Starts of the parts of a counting sort from counts stored one place later.
void accumulate(Span<uint32_t> first, uint32_t n) {
  for (uint32_t i = 0; i < n; ++i) first[i + 1] += first[i];
}
// After filling, the running starts are the ends of the parts: back by one.
void step_back(Span<uint32_t> first, uint32_t n) {
  for (uint32_t i = n; i > 0; --i) first[i] = first[i - 1];
  first[0] = 0;
}

// Hands every vertex to its balls. On ball[0] of a positive vertex the loop comes in along the circle of ball[1] and
// leaves along that of ball[2]; the roles go round cyclically over the three balls, and swap for a negative vertex.
void distribute_vertices(uint32_t n, BoundaryStructure &boundary) {
  const Span<uint32_t> first = boundary.first_use;
  for (uint32_t i = 0; i <= n; ++i) first[i] = 0;
  for (const VertexRecord &vertex : boundary.vertices.items()) {
    for (const uint32_t ball : vertex.ball) ++first[ball + 1];
  }
  accumulate(first, n);
  for (uint32_t v = 0; v < boundary.vertices.size(); ++v) {
    const VertexRecord &vertex = boundary.vertices[v];
    for (uint32_t t = 0; t < 3; ++t) {
      const uint32_t following = vertex.ball[(t + 1) % 3];
      const uint32_t preceding = vertex.ball[(t + 2) % 3];
      VertexUse &use = boundary.uses[first[vertex.ball[t]]++];
      use.vertex = v;
      use.in = vertex.positive() ? following : preceding;
      use.out = vertex.positive() ? preceding : following;
    }
  }
  step_back(first, n);
}

void distribute_circles(uint32_t n, BoundaryStructure &boundary) {
  const Span<uint32_t> first = boundary.first_circle_side;
  for (uint32_t i = 0; i <= n; ++i) first[i] = 0;
  for (const CircleRecord &circle : boundary.circles.items()) {
    for (const uint32_t ball : circle.ball) ++first[ball + 1];
  }
  accumulate(first, n);
  for (uint32_t c = 0; c < boundary.circles.size(); ++c) {
    for (uint32_t side = 0; side < 2; ++side) {
      boundary.circle_side[first[boundary.circles[c].ball[side]]++] = 2 * c + side;
    }
  }
  step_back(first, n);
}

// The rank of the tie rule for balls of the set that are no duplicates of each other.
bool ranks_before(const BallSet &balls, uint32_t a, uint32_t b) {
  if (balls.x[a] != balls.x[b]) return balls.x[a] < balls.x[b];
  if (balls.y[a] != balls.y[b]) return balls.y[a] < balls.y[b];
  if (balls.z[a] != balls.z[b]) return balls.z[a] < balls.z[b];
  return balls.r[a] < balls.r[b];  // GCOVR_EXCL_LINE: of two balls with one centre the inner one owns nothing
}

// Finds where the arcs that start at the uses of one ball end.
void chain_uses(const BallSet &balls, uint32_t i, BoundaryStructure &boundary) {
  const uint32_t first = boundary.first_use[i];
  const Span<VertexUse> uses = boundary.uses.part(first, boundary.first_use[i + 1]);
  const auto direction = [&balls, i](uint32_t j) {
    return exact::Vector{static_cast<int64_t>(balls.x[j] - balls.x[i]), static_cast<int64_t>(balls.y[j] - balls.y[i]),
                         static_cast<int64_t>(balls.z[j] - balls.z[i])};
  };
  for (VertexUse &use : uses) {
    use.next = first + end_of_arc(uses, use, direction);
    use.loop = no_id;
  }
}

}  // namespace

void assemble_loops(const BallSet &balls, BoundaryStructure &boundary) {
  const uint32_t n = balls.n;
  distribute_vertices(n, boundary);
  distribute_circles(n, boundary);
  uint32_t loops = 0;
  for (uint32_t i = 0; i < n; ++i) {
    const uint32_t first = boundary.first_use[i];
    const uint32_t last = boundary.first_use[i + 1];
    // Sums over a ball's uses run in this order; it is fixed by the balls themselves, so that ids have no effect on any
    // bit.
    sort_in_place(boundary.uses.part(first, last), [&balls](const VertexUse &a, const VertexUse &b) {
      return a.out != b.out ? ranks_before(balls, a.out, b.out) : ranks_before(balls, a.in, b.in);
    });
    for (uint32_t u = first; u < last; ++u) {
      const VertexRecord &vertex = boundary.vertices[boundary.uses[u].vertex];
      const uint32_t t = vertex.ball[0] == i ? 0 : vertex.ball[1] == i ? 1 : 2;
      boundary.use_at[3 * boundary.uses[u].vertex + t] = u;
    }
    sort_in_place(boundary.circle_side.part(boundary.first_circle_side[i], boundary.first_circle_side[i + 1]),
                  [&](uint32_t a, uint32_t b) {
                    return ranks_before(balls, boundary.circles[a / 2].ball[1 - a % 2],
                                        boundary.circles[b / 2].ball[1 - b % 2]);
                  });
    chain_uses(balls, i, boundary);

    boundary.first_loop[i] = loops;
    for (uint32_t start = first; start < last; ++start) {
      if (boundary.uses[start].loop != no_id) continue;
      boundary.loop_cap[loops] = boundary.uses[start].out;
      for (uint32_t u = start; boundary.uses[u].loop == no_id; u = boundary.uses[u].next) boundary.uses[u].loop = loops;
      ++loops;
    }
    for (uint32_t s = boundary.first_circle_side[i]; s < boundary.first_circle_side[i + 1]; ++s) {
      CircleRecord &circle = boundary.circles[boundary.circle_side[s] / 2];
      const uint32_t side = boundary.circle_side[s] % 2;
      circle.loop[side] = loops;
      boundary.loop_cap[loops++] = circle.ball[1 - side];
    }
  }
  boundary.first_loop[n] = loops;
  boundary.loop_count = loops;
}

}  // namespace hsp
