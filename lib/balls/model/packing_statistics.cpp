#include "model/packing_statistics.hpp"

#include "core/extremes.hpp"
#include "model/block_sweep.hpp"

namespace hsp {
namespace {

// Keeps the smallest |c_i c_j| / max(r_i, r_j).
struct ClosestPair {
  double ratio = std::numeric_limits<double>::infinity();
  bool coincident = false;

  void offer(const BallSet &balls, uint32_t i, uint32_t j) {
    const double larger = balls.r[i] > balls.r[j] ? balls.r[i] : balls.r[j];
    const Vec3 between = balls.difference(i, j);
    const double squared = dot(between, between);
    coincident = coincident || squared == 0.0;
    if (larger > 0.0) {
      const double candidate = std::sqrt(squared) / larger;
      if (candidate < ratio) ratio = candidate;
    }
  }
};

// Whether |c_i c_j| < r_i + r_j, exactly.
bool overlap(const BallSet &balls, uint32_t i, uint32_t j) {
  const exact::LatticeBall a = balls.ball(i);
  const exact::LatticeBall b = balls.ball(j);
  const int64_t sum = a.radius + b.radius;
  const exact::Vector d = b.centre - a.centre;
  return exact::within(d, sum) && exact::squared_within(d) < static_cast<uint64_t>(sum * sum);
}

// Offers every pair whose centres lie in the same cube or in neighbouring cubes of the given side. These are all pairs
// up to that distance, and perhaps others. The number of a cube is its first ball, from which a list leads to the
// others.
void offer_neighbouring_cubes(CubeGrid &grid, Span<uint32_t> slots, int64_t side, ClosestPair &closest) {
  const BallSet &balls = grid.balls();
  const Span<uint32_t> next = grid.scratch_links();
  CubeSlots first_balls(slots);
  first_balls.clear(balls.n);
  const auto cube_of = [&](uint32_t ball) { return CubeGrid::cube_at(balls.ball(ball).centre, side); };
  const auto first_in = [&](const CubeCoordinates &cube) { return first_balls.find(cube, linear_hash(cube), cube_of); };
  for (uint32_t i = 0; i < balls.n; ++i) {
    const uint32_t first = first_in(cube_of(i));
    if (first == no_id) {
      next[i] = no_id;
      first_balls.insert(i, cube_of);
    } else {
      next[i] = next[first];
      next[first] = i;
    }
  }
  for (uint32_t i = 0; i < balls.n && closest.ratio > 0.0; ++i) {
    const CubeCoordinates centre = cube_of(i);
    for (int64_t dz = -1; dz <= 1; ++dz) {
      for (int64_t dy = -1; dy <= 1; ++dy) {
        for (int64_t dx = -1; dx <= 1; ++dx) {
          uint32_t j = first_in({centre.x + dx, centre.y + dy, centre.z + dz});
          for (; j != no_id; j = next[j]) {
            if (j > i) closest.offer(balls, i, j);
          }
        }
      }
    }
  }
}

struct Overlaps {
  uint64_t all = 0;
  uint32_t most = 0;

  void add(uint32_t of_ball) {
    all += of_ball;
    if (of_ball > most) most = of_ball;
  }
};

// Counts overlaps among all balls around each ball's cube, and finds the closest pair among these.
Overlaps count_in_cubes(const CubeGrid &grid, ClosestPair &closest) {
  const BallSet &balls = grid.balls();
  Overlaps overlaps;
  BlockSweep sweep(grid);
  for (uint32_t cube = 0; cube < grid.cubes(); ++cube) {
    const CubeBlock &block = sweep.block_around(cube);
    const BallRange own = grid.balls_in(cube);
    for (uint32_t i = own.first; i < own.last; ++i) {
      uint32_t count = 0;
      for (uint32_t k = 0; k < block.ranges; ++k) {
        for (uint32_t j = block.range[k].first; j < block.range[k].last; ++j) {
          if (j == i) continue;
          if (overlap(balls, i, j)) ++count;
          if (j > i) closest.offer(balls, i, j);
        }
      }
      overlaps.add(count);
    }
  }
  return overlaps;
}

// The same by levels of radii, with the closest pair of the set. A pair whose ratio is at most 1 overlaps. To find
// larger ratios, balls that do not meet are looked at, too, as far away as the ratio says. False if no pair has a ratio
// up to largest_ratio.
bool count_in_levels(CubeGrid &grid, const RadiusLevels &levels, Overlaps &overlaps, ClosestPair &closest) {
  constexpr double largest_ratio = 64.0;
  const BallSet &balls = grid.balls();
  const Span<uint32_t> near = grid.scratch_links();
  // Visits all balls whose distance is at most `reach` plus their own radius, and perhaps others: all balls if `reach`
  // is larger than radii can be.
  const auto visit_near = [&](uint32_t i, double reach, auto visit) {
    const double steps = static_cast<double>(static_cast<int64_t>(reach) + 2);
    const QueryBall query{balls.x[i], balls.y[i], balls.z[i], steps, i};
    const uint32_t count = steps < 0x1p30 ? levels.find(query, near.data(), near.size()) : no_id;
    const bool are_found = count <= near.size();
    for (uint32_t k = 0; k < (are_found ? count : balls.n); ++k) {
      const uint32_t j = are_found ? near[k] : k;
      if (j != i) visit(j);
    }
  };
  for (uint32_t i = 0; i < balls.n; ++i) {
    uint32_t count = 0;
    visit_near(i, balls.r[i], [&](uint32_t j) {
      count += overlap(balls, i, j) ? 1U : 0U;
      closest.offer(balls, i, j);
    });
    overlaps.add(count);
  }
  for (double ratio = 1.0; closest.ratio > ratio;) {
    if (ratio == largest_ratio) return false;
    ratio = smaller_of(closest.ratio, 4 * ratio);
    for (uint32_t i = 0; i < balls.n; ++i) {
      visit_near(i, smaller_of(closest.ratio, ratio) * balls.r[i], [&](uint32_t j) { closest.offer(balls, i, j); });
    }
  }
  return true;
}

}  // namespace

PackingStatistics packing_statistics(CubeGrid &grid) {
  const BallSet &balls = grid.balls();
  PackingStatistics figures;
  figures.no_pair = balls.n < 2;
  if (balls.n == 0) return figures;

  double smallest = balls.r[0];
  for (uint32_t i = 1; i < balls.n; ++i) {
    if (balls.r[i] < smallest) smallest = balls.r[i];
  }
  figures.zero_radius = smallest == 0.0;
  if (!figures.zero_radius) figures.k = static_cast<double>(balls.largest_radius) / smallest;

  ClosestPair closest;
  Overlaps overlaps;
  const RadiusLevels *const levels = grid.levels();
  const bool all_seen = levels != nullptr && count_in_levels(grid, *levels, overlaps, closest);
  if (!all_seen) overlaps = count_in_cubes(grid, closest);
  figures.max_overlaps = overlaps.most;
  figures.mean_overlaps = static_cast<double>(overlaps.all) / static_cast<double>(balls.n);

  // Balls in cubes that are not neighbours are further apart than the side of the cubes, so their ratio exceeds side /
  // r_max. Coarser cubes are tried only while such a pair could still have the smallest ratio: in sets whose balls
  // hardly meet.
  const double r_max = static_cast<double>(balls.largest_radius);
  constexpr int64_t widest_set = int64_t{1} << 52;
  const auto may_be_closer = [&](int64_t side) {
    return !all_seen && balls.n >= 2 && side < widest_set && closest.ratio * r_max > static_cast<double>(side);
  };
  if (may_be_closer(grid.side())) {
    grid.lend_slots([&](Span<uint32_t> slots) {
      for (int64_t side = grid.side(); may_be_closer(side);) {
        side *= 4;
        offer_neighbouring_cubes(grid, slots, side, closest);
      }
    });
  }
  figures.coincident = closest.coincident;
  figures.no_pair = !is_finite(closest.ratio);
  figures.rho = figures.no_pair || figures.coincident ? 0.0 : closest.ratio;
  return figures;
}

}  // namespace hsp
