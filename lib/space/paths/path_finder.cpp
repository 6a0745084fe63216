#include "paths/path_finder.hpp"

#include <utility>

#include "cells/cell_location.hpp"
#include "paths/free_segments.hpp"

namespace hsp {

void PathFinder::carve(Workspace &workspace, const PathLimits &limits) {
  builder_.carve(workspace, limits.cells, true);
  search_.carve(workspace, limits.cells);
  crossing_.carve(workspace, limits.cells.cube_balls);
  points_ = FixedVector<exact::Vector>(workspace.take<exact::Vector>(limits.points));
}

Status PathFinder::build(const CubeGrid &grid, Patience patience) {
  points_.clear();
  needed_points_ = 0;
  const Status status = builder_.build(grid, patience);
  if (status != Status::ok) return status;
  return search_.prepare(builder_.structure(), patience) ? Status::ok : Status::stopped;
}

Status PathFinder::find(const BallSet &balls, const exact::Vector &from, const exact::Vector &to, PathSummary &summary,
                        Patience patience) {
  const FreeSpace &space = builder_.structure();
  points_.clear();
  needed_points_ = 0;
  summary = {PathEnds::covered, false, 0.0, 0.0};
  const uint32_t first = cell_at(balls, space, from), last = cell_at(balls, space, to);
  if (first == no_id || last == no_id) return Status::ok;
  summary.ends = PathEnds::apart;
  if (space.cell(first).region != space.cell(last).region) return Status::ok;
  if (const Status status = search_.find(space, first, from, last, to, patience); status != Status::ok) return status;

  points_.push(from);
  exact::Vector here = from;
  for (uint32_t cell = first; cell != no_id; cell = search_.next(cell)) {
    if (!patience.allows(10000)) return stop();
    const uint32_t next = search_.next(cell);
    const exact::Vector there = next == no_id ? to : search_.entry(next);
    crossing_.add(balls, space, cell, here, there, points_);
    points_.push(there);
    here = there;
  }
  needed_points_ = clamped_count(points_.required());
  if (points_.overflowed()) {
    points_.clear();
    return Status::capacity;
  }
  // Twice, the second time from the other end: there shortcuts begin elsewhere.
  for (uint32_t time = 0; time < 2; ++time) {
    shorten(balls, patience);
    if (!patience.allows(0)) return stop();
    for (uint32_t a = 0, b = points_.size() - 1; a < b; ++a, --b) std::swap(points_[a], points_[b]);
  }
  summary = {PathEnds::connected, true, 0.0, segment_clearance(balls, from, from)};
  for (uint32_t k = 1; k < points_.size(); ++k) {
    if (!patience.allows(20000 + 100 * uint64_t{balls.n})) return stop();
    const exact::Vector &a = points_[k - 1], &b = points_[k];
    summary.certified = summary.certified && is_free_segment(balls, space, a, b);
    summary.length += distance(a, b);
    const double clearance = segment_clearance(balls, a, b);
    summary.clearance = clearance < summary.clearance ? clearance : summary.clearance;
  }
  return Status::ok;
}

Status PathFinder::stop() {
  points_.clear();
  return Status::stopped;
}

// Shortens a path. From each point it goes straight to one as late as can be found by doubling steps, then halving
// them.
void PathFinder::shorten(const BallSet &balls, Patience &patience) {
  const FreeSpace &space = builder_.structure();
  const uint32_t last = points_.size() - 1;
  uint32_t kept = 0;
  const auto is_free = [&](uint32_t to) {
    return patience.allows(10000) && is_free_segment(balls, space, points_[kept], points_[to]);
  };
  for (uint32_t at = 0; at < last;) {
    uint32_t reached = at + 1, beyond = last + 1;
    if (is_free(last)) {
      reached = last;
    } else {
      for (uint32_t step = 2; step <= last - at && beyond > last; step *= 2) {
        if (is_free(at + step)) {
          reached = at + step;
        } else {
          beyond = at + step;
        }
      }
      while (beyond - reached > 1) {
        const uint32_t middle = reached + (beyond - reached) / 2;
        (is_free(middle) ? reached : beyond) = middle;
      }
    }
    points_[++kept] = points_[reached];
    at = reached;
  }
  points_.shrink(kept + 1);
}

}  // namespace hsp
