#include "surface/probe_grid.hpp"

#include "core/decimal.hpp"
#include "model/cube_grid.hpp"

namespace hsp {
namespace {

// Neighbouring cubes differ by at most 2 in each coordinate.
constexpr bool tells_neighbours_apart() {
  for (int64_t z = -2; z <= 2; ++z) {
    for (int64_t y = -2; y <= 2; ++y) {
      for (int64_t x = -2; x <= 2; ++x) {
        const bool same = x == 0 && y == 0 && z == 0;
        if (!same && static_cast<uint32_t>(linear_hash({x, y, z})) == 0) return false;
      }
    }
  }
  return true;
}
static_assert(tells_neighbours_apart());

uint64_t buckets_for(uint32_t vertices) {
  uint64_t buckets = 1;
  while (buckets < vertices) buckets *= 2;
  return buckets;
}

}  // namespace

void ProbeGrid::carve(Workspace &workspace, uint32_t vertices) {
  position_ = workspace.take<Position>(vertices);
  first_ = workspace.take<uint32_t>(buckets_for(vertices) + 1);
  entry_ = workspace.take<Entry>(vertices);
}

// Coordinates below 2^51 are rounded by less than a step, which the side allows for.
CubeCoordinates ProbeGrid::cube_of(const BallSet &balls, uint32_t v) const {
  const Position &p = position_[v];
  return CubeGrid::cube_at({nearest(balls.x[p.ball] + p.offset.x), nearest(balls.y[p.ball] + p.offset.y),
                            nearest(balls.z[p.ball] + p.offset.z)},
                           side_);
}

void ProbeGrid::build(const BallSet &balls, const Boundary &boundary) {
  const uint32_t n = boundary.vertex_count();
  side_ = 2 * balls.probe_steps + 4;
  buckets_ = static_cast<uint32_t>(buckets_for(n));
  // Counting sort: first_[b] counts bucket b, then is where it ends, then where it starts.
  for (uint32_t b = 0; b <= buckets_; ++b) first_[b] = 0;
  for (uint32_t v = 0; v < n; ++v) {
    position_[v] = position_of_vertex(balls, boundary, v);
    ++first_[bucket_of(linear_hash(cube_of(balls, v)))];
  }
  uint32_t sum = 0;
  for (uint32_t b = 0; b <= buckets_; ++b) {
    sum += first_[b];
    first_[b] = sum;
  }
  for (uint32_t v = n; v-- > 0;) {
    const uint64_t key = linear_hash(cube_of(balls, v));
    entry_[--first_[bucket_of(key)]] = {static_cast<uint32_t>(key), v};
  }
}

}  // namespace hsp
