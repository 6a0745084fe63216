#include "maps/region_builder.hpp"

namespace hsp {

void RegionBuilder::carve(Workspace &workspace, const StickLimits &limits) {
  regions_.carve(workspace, limits);
  arcs_.carve(workspace, limits);
  linker_.carve(workspace, limits);
  loops_.carve(workspace, limits);
  balls_ = workspace.take<SeenBall>(limits.balls);
  edges_ = limits.edges;
}

void RegionBuilder::add_paths() {
  for (uint32_t l = 0; l < regions_.loops.size(); ++l) {
    const uint32_t owner = regions_.loops[l].owner;
    if (owner == no_id) break;
    if (l == 0 || owner != regions_.loops[l - 1].owner) regions_.first_loop[regions_.paths++] = l;
  }
}

Status RegionBuilder::build(const StickView &view, Span<const StickPair> pairs, Span<const SweptBox> boxes,
                            Span<const double> depth) {
  regions_.clear();
  const uint32_t balls = depth.size() - 2 * view.sticks.size();
  for (uint32_t i = 0; i < balls; ++i) {
    const PlacedBall &ball = view.balls[i];
    balls_[i] = {ball.centre.x, ball.centre.y, ball.centre.z, ball.r, i, 0};
  }
  regions_.scene = {balls_.part(0, balls), view.sticks.items()};
  arcs_.find(regions_.scene, view, pairs);
  if (arcs_.overflowed() || arcs_.needed_edges() > edges_) return Status::capacity;
  if (!arcs_.certain() || !linker_.link(arcs_.arcs(), regions_)) return Status::check;
  const BodySight sight(regions_.scene, boxes, arcs_.inside());
  if (!loops_.find(sight, depth, regions_)) return Status::check;
  add_paths();
  regions_.exist = true;
  return Status::ok;
}

}  // namespace hsp
