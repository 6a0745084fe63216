#include "cells/cube_cover.hpp"

#include "core/rows.hpp"
#include "core/sorting.hpp"
#include "model/grid_order.hpp"

namespace hsp {
namespace {

// The squared distance of a position from a cube along one axis. The centre of a ball of radius r < 2^30 is at most r
// away from cubes that the ball meets, and 3 r from a cube beside one of these. So squares are below 9 * 2^60, and
// their sums over the axes below 11 * 2^60.
uint64_t squared_gap(int64_t position, int64_t cube, int64_t side) {
  const int64_t before = cube * side - position, behind = -side - before;
  const int64_t gap = (before > 0 ? before : 0) + (behind > 0 ? behind : 0);
  return static_cast<uint64_t>(gap) * static_cast<uint64_t>(gap);
}

// Calls visit(cube) for each cube that a ball meets.
template <class Visit>
void for_each_cube(const exact::LatticeBall &ball, const CubeAxis &axis, Visit visit) {
  const auto first = [&](int64_t c) { return axis.cube_at(c - ball.radius - 1); };
  const auto last = [&](int64_t c) { return axis.cube_at(c + ball.radius); };
  const exact::Vector &c = ball.centre;
  const CubeCoordinates low{first(c.x), first(c.y), first(c.z)}, high{last(c.x), last(c.y), last(c.z)};
  const uint64_t reach = static_cast<uint64_t>(ball.radius * ball.radius);
  for (int64_t z = low.z; z <= high.z; ++z) {
    const uint64_t in_z = squared_gap(c.z, z, axis.side());
    for (int64_t y = low.y; y <= high.y; ++y) {
      const uint64_t in_yz = in_z + squared_gap(c.y, y, axis.side());
      for (int64_t x = low.x; x <= high.x; ++x) {
        if (in_yz + squared_gap(c.x, x, axis.side()) <= reach) visit(CubeCoordinates{x, y, z});
      }
    }
  }
}

}  // namespace

bool meets_cube(const exact::LatticeBall &ball, const CubeCoordinates &cube, int64_t side) {
  return squared_gap(ball.centre.x, cube.x, side) + squared_gap(ball.centre.y, cube.y, side) +
             squared_gap(ball.centre.z, cube.z, side) <=
         static_cast<uint64_t>(ball.radius * ball.radius);
}

void CubeCover::carve(Workspace &workspace, uint32_t cubes, uint32_t entries) {
  capacity_ = cubes;
  const auto slots = workspace.take<uint32_t>(CubeSlots::slots_for(cubes));
  const auto coordinates = workspace.take<CubeCoordinates>(cubes);
  table_ = CubeTable(slots, coordinates);
  sorted_ = workspace.take<CubeCoordinates>(cubes);
  first_entry_ = workspace.take<uint32_t>(static_cast<uint64_t>(cubes) + 1);
  entries_ = workspace.take<uint32_t>(entries);
}

bool CubeCover::build(const CubeGrid &grid, Patience &patience) {
  const BallSet &balls = grid.balls();
  const CubeAxis axis(grid.side());
  // A cube without room is counted once for every ball that meets it.
  uint64_t cubes = 0, entries = 0;
  table_.clear(capacity_);
  for (uint32_t i = 0; i < balls.n; ++i) {
    if (!patience.allows(2000)) return false;
    for_each_cube(balls.ball(i), axis, [&](const CubeCoordinates &cube) {
      ++entries;
      const uint32_t known = table_.find(cube);
      if (known != no_id) {
        ++first_entry_[known];
      } else if (cubes++ < capacity_) {
        first_entry_[table_.count()] = 1;
        table_.append(cube);
      }
    });
  }
  needed_cubes_ = clamped_count(cubes);
  needed_entries_ = clamped_count(entries);
  if (cubes > capacity_ || entries > entries_.size()) return false;

  const Span<CubeCoordinates> sorted = sorted_.part(0, needed_cubes_);
  for (uint32_t k = 0; k < sorted.size(); ++k) sorted[k] = table_.coordinates(k);
  sort_in_place(sorted, [&](const CubeCoordinates &a, const CubeCoordinates &b) {
    return patience.allows(30) && comes_before(a, b);
  });
  if (!patience.allows(0)) return false;
  // How many balls meet each cube, in the cubes' order; there are no fewer entries than cubes.
  for (uint32_t k = 0; k < needed_cubes_; ++k) {
    if (!patience.allows(200)) return false;
    entries_[k] = first_entry_[table_.find(sorted[k])];
  }
  table_.clear(needed_cubes_);
  for (const CubeCoordinates &cube : sorted) table_.append(cube);
  most_balls_ = 0;
  for (uint32_t k = 0; k < needed_cubes_; ++k) {
    most_balls_ = larger_count(most_balls_, entries_[k]);
    first_entry_[k] = entries_[k];
  }
  end_rows(first_entry_, needed_cubes_);
  for (uint32_t i = balls.n; i-- > 0;) {
    if (!patience.allows(2000)) return false;
    const auto enter = [&](const CubeCoordinates &cube) { entries_[--first_entry_[table_.find(cube)]] = i; };
    for_each_cube(balls.ball(i), axis, enter);
  }
  return true;
}

}  // namespace hsp
