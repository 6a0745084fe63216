#include "maps/stick_map_builder.hpp"

namespace hsp {

void StickMapBuilder::carve(Workspace &workspace, const StickLimits &limits) {
  map_.carve(workspace, limits);
  arcs_.carve(workspace, limits);
  const uint64_t balls = limits.balls;
  const uint64_t sticks = limits.sticks;
  const MapSizes most{balls + 2 * sticks, 2 * balls + 3 * sticks, limits.edges};
  linker_.carve(workspace, most);
  faces_.carve(workspace, most);
  balls_ = workspace.take<SeenBall>(limits.balls);
  order_ = workspace.take<uint32_t>(most.bodies);
  edges_ = limits.edges;
}

Status StickMapBuilder::build(const StickView &view, Span<const StickPair> pairs, Span<const SweptBox> boxes,
                              Span<const double> depth, Patience &patience) {
  map_.clear();
  const Span<SeenBall> balls = balls_.part(0, depth.size() - 2 * view.sticks.size());
  for (uint32_t i = 0; i < balls.size(); ++i) {
    const PlacedBall &ball = view.balls[i];
    balls[i] = {ball.centre.x, ball.centre.y, ball.centre.z, ball.r, i, 0};
  }
  const Span<uint32_t> order = order_.part(0, depth.size());
  for (uint32_t k = 0; k < order.size(); ++k) order[k] = k;
  sort_in_place(order, [depth](uint32_t a, uint32_t b) { return depth[a] != depth[b] ? depth[a] < depth[b] : a < b; });
  if (!patience.allows(500 * uint64_t{order.size()})) return Status::stopped;
  map_.scene = {{balls}, view.sticks.items(), order};
  if (!arcs_.find(map_.scene, view, pairs, balls, patience)) return Status::stopped;
  if (arcs_.overflowed() || arcs_.needed_edges() > edges_) return Status::capacity;
  if (!arcs_.certain()) return Status::check;
  linker_.count_edges(arcs_.arcs(), map_.scene);
  const bool fits = linker_.link(map_, patience) && faces_.find(sight(boxes), MapTrust::nothing, map_, patience);
  if (!patience.allows(0)) return Status::stopped;
  if (!fits) return Status::check;
  uint32_t paths = 0;
  uint32_t last = no_id;
  for (uint32_t k = 0; k < map_.loops.size(); ++k) {
    const uint32_t owner = map_.loops[map_.loop_order[k]].owner;
    if (owner != last && owner != no_id) map_.first_loop[paths++] = k;
    last = owner;
  }
  map_.exist = true;
  return Status::ok;
}

}  // namespace hsp
