#include "maps/map_builder.hpp"

namespace hsp {

void MapBuilder::carve(Workspace &workspace, const MapLimits &limits) {
  limit(limits);
  map_.carve(workspace, limits.edges);
  seen_.carve(workspace, limits.balls, limits.neighbours);
  discs_.carve(workspace, limits.balls);
  arcs_.carve(workspace, limits);
  const MapSizes most{limits.balls, limits.balls, limits.edges};
  linker_.carve(workspace, most);
  faces_.carve(workspace, most);
}

Status MapBuilder::build_moved(const BallSet &balls, const Perturbation &perturbation, Patience &patience) {
  map_.clear();
  seen_.place(balls, map_.frame, perturbation, patience);
  if (!patience.allows(100 * uint64_t{balls.n})) return Status::stopped;
  discs_.build(seen_.balls());
  discs_.mark_inside(seen_.balls(), patience);
  map_.scene.balls = seen_.balls();
  map_.perturbation = perturbation.size * static_cast<double>(balls.largest_radius);
  if (!arcs_.find(seen_, discs_, patience)) return Status::stopped;
  needed_.neighbours = larger_count(needed_.neighbours, arcs_.needed_neighbours());
  if (arcs_.overflowed()) {
    needed_.edges = larger_count(needed_.edges, arcs_.needed_edges());
    return Status::capacity;
  }
  // Every arc becomes an edge at least.
  needed_.edges = larger_count(needed_.edges, arcs_.arcs().size());
  if (!arcs_.certain()) return Status::check;
  const uint32_t edges = clamped_count(linker_.count_edges(arcs_.arcs(), map_.scene));
  needed_.edges = larger_count(needed_.edges, edges);
  if (edges > limits_.edges) return Status::capacity;
  const MapTrust trust = arcs_.complete() ? MapTrust::all_arcs : MapTrust::labels;
  const bool fits = linker_.link(map_, patience) && faces_.find(discs_, trust, map_, patience);
  if (!patience.allows(0)) return Status::stopped;
  return fits ? Status::ok : Status::check;
}

Status MapBuilder::build(const CubeGrid &grid, const ViewDirection &direction, Patience patience) {
  const BallSet &balls = grid.balls();
  needed_ = {};
  map_.clear();
  if (const Status status = look_from(direction, map_.frame); status != Status::ok) return status;
  needed_.balls = balls.n;
  if (balls.n > limits_.balls) return Status::capacity;
  centre_on(balls, map_.frame);
  if (!seen_.choose(grid, map_.frame, patience)) return Status::stopped;
  for (const Perturbation &perturbation : perturbations) {
    Status status = build_moved(balls, perturbation, patience);
    if (seen_.some_are_late() && (status == Status::check || status == Status::ok)) {
      seen_.ask_of_those_inside(patience);
      status = build_moved(balls, perturbation, patience);
    }
    if (status != Status::check) return status;
  }
  map_.clear();
  return Status::degenerate;
}

}  // namespace hsp
