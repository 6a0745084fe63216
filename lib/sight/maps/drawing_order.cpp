#include "maps/drawing_order.hpp"

namespace hsp {

void DrawingOrder::carve(Workspace &workspace, const StickLimits &limits) {
  const uint64_t bodies = limits.balls + 2 * static_cast<uint64_t>(limits.sticks);
  above_.carve(workspace, limits);
  waiting_ = workspace.take<uint32_t>(bodies);
  heap_ = workspace.take<uint32_t>(bodies);
}

uint32_t DrawingOrder::sort(Span<const StickPair> pairs, Span<const double> depth, Span<uint32_t> order) {
  const uint32_t bodies = depth.size();
  for (uint32_t k = 0; k < bodies; ++k) waiting_[k] = 0;
  for (const StickPair &pair : pairs) ++waiting_[pair.above];
  above_.sort(pairs, bodies);

  const auto before = [depth](uint32_t a, uint32_t b) { return depth[a] != depth[b] ? depth[a] < depth[b] : a < b; };
  uint32_t ready = 0;
  const auto push = [&](uint32_t body) {
    uint32_t hole = ready++;
    for (; hole > 0 && before(body, heap_[(hole - 1) / 2]); hole = (hole - 1) / 2) heap_[hole] = heap_[(hole - 1) / 2];
    heap_[hole] = body;
  };
  const auto pop = [&] {
    const uint32_t least = heap_[0];
    const uint32_t last = heap_[--ready];
    uint32_t hole = 0;
    for (uint32_t child = 1; child < ready; child = 2 * hole + 1) {
      if (child + 1 < ready && before(heap_[child + 1], heap_[child])) ++child;
      if (!before(heap_[child], last)) break;
      heap_[hole] = heap_[child];
      hole = child;
    }
    heap_[hole] = last;
    return least;
  };
  for (uint32_t k = 0; k < bodies; ++k) {
    if (waiting_[k] == 0) push(k);
  }
  uint32_t placed = 0;
  while (ready > 0) {
    const uint32_t body = pop();
    order[placed++] = body;
    for (const uint32_t above : above_.of(body)) {
      if (--waiting_[above] == 0) push(above);
    }
  }
  return placed;
}

// Every body without a rank lies over another one without a rank. A walk down that has as many steps as there
// are bodies is in a cycle.
DrawingOrder::Cycle DrawingOrder::find_cycle(Span<const StickPair> pairs, uint32_t bodies) {
  for (uint32_t k = 0; k < bodies; ++k) heap_[k] = no_id;
  uint32_t body = no_id;
  for (const StickPair &pair : pairs) {
    if (waiting_[pair.below] == 0 || waiting_[pair.above] == 0) continue;
    heap_[pair.above] = pair.below;
    body = pair.above;
  }
  if (body == no_id) return {no_id, 0};
  for (uint32_t k = 0; k < bodies; ++k) body = heap_[body];
  Cycle cycle{body, 1};
  for (uint32_t other = heap_[body]; other != body; other = heap_[other]) {
    cycle.last = other > cycle.last ? other : cycle.last;
    ++cycle.length;
  }
  return cycle;
}

}  // namespace hsp
