#include "maps/arc_finder.hpp"

#include "maps/crease_arcs.hpp"
#include "maps/silhouette_arcs.hpp"

namespace hsp {

void ArcFinder::carve(Workspace &workspace, const MapLimits &limits) {
  arcs_ = FixedVector<MapArc>(workspace.take<MapArc>(limits.edges));
  near_ = FixedVector<uint32_t>(workspace.take<uint32_t>(limits.neighbours));
  const uint64_t intervals = static_cast<uint64_t>(most_hidden_per_occluder) * limits.neighbours;
  hidden_ = FixedVector<HiddenInterval>(workspace.take<HiddenInterval>(intervals));
}

void ArcFinder::find(SeenBalls &seen, const DiscGrid &grid) {
  arcs_.clear();
  needed_neighbours_ = 0;
  certain_ = complete_ = true;
  const Span<const SeenBall> balls = seen.balls();
  for (uint32_t i = 0; i < balls.size(); ++i) {
    if (balls[i].inside != 0) continue;
    grid.gather(i, near_);
    needed_neighbours_ = larger_count(needed_neighbours_, clamped_count(near_.required()));
    if (near_.overflowed()) continue;
    const Span<const uint32_t> near = near_.items();
    if (!find_silhouette_arcs(seen, i, near, hidden_, arcs_)) complete_ = false;
    for (const uint32_t k : near) {
      if (seen.is_nearer(k, i) && !find_crease_arcs(seen, i, k, near, hidden_, arcs_)) certain_ = false;
    }
  }
}

}  // namespace hsp
