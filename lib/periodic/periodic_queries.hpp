// Which balls of a periodic box, and which images of them, meet a ball in the box.
#pragma once

#include "model/query_hits.hpp"
#include "periodic/periodic_union.hpp"

namespace hsp {

// Calls sink(k) for every ball or image that meets the ball around a point of the box, in the grid's order. Its radius
// must not be larger than that of the largest ball: images that are farther away are not there.
template <class Sink>
void visit_balls_at(const PeriodicUnion &periodic, const exact::Vector &point, int64_t radius, Sink sink) {
  const CubeGrid &grid = periodic.grid();
  const BallSet &set = grid.balls();
  const Vec3 p = to_double(point);
  const double r = static_cast<double>(radius);
  const CubeBlock block = grid.block_around(grid.cube_at(point));
  for (uint32_t k = 0; k < block.ranges; ++k) {
    for (uint32_t j = block.range[k].first; j < block.range[k].last; ++j) {
      if (meet(set.x[j] - p.x, set.y[j] - p.y, set.z[j] - p.z, set.r[j] + r)) sink(set.caller[j]);
    }
  }
}

// The balls that meet the caller's ball i, without itself; its own images may be among them.
template <class Sink>
void visit_neighbours_in_box(const PeriodicUnion &periodic, uint32_t i, Sink sink) {
  const exact::LatticeBall own = periodic.balls().ball(periodic.grid().grid_index(i));
  visit_balls_at(periodic, own.centre, own.radius, [&](uint32_t k) {
    if (k != i) sink(k);
  });
}

}  // namespace hsp
