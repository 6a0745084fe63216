#include "grid/cube_grid.hpp"

#include "core/sorting.hpp"

namespace hsp {
namespace {

// floor(value / side). The estimate in double is off by at most one, the remainder corrects it.
int64_t floor_divide(int64_t value, int64_t side) {
  int64_t quotient = static_cast<int64_t>(static_cast<double>(value) / static_cast<double>(side));
  const int64_t rest = value - quotient * side;
  if (rest < 0) --quotient;
  if (rest >= side) ++quotient;
  return quotient;
}

}  // namespace

CubeCoordinates CubeGrid::cube_at(const exact::Vector &point, int64_t side) {
  return {floor_divide(point.x, side), floor_divide(point.y, side), floor_divide(point.z, side)};
}

void CubeGrid::carve(Workspace &workspace, uint32_t n) {
  capacity_ = n;
  const auto slots = workspace.take<uint32_t>(CubeTable::slots_for(n));
  const auto cubes = workspace.take<CubeCoordinates>(n);
  table_ = CubeTable(slots, cubes);
  first_ball_ = workspace.take<uint32_t>(static_cast<uint64_t>(n) + 1);
  place_ = workspace.take<uint32_t>(n);
  balls_.x = workspace.take<double>(n);
  balls_.y = workspace.take<double>(n);
  balls_.z = workspace.take<double>(n);
  balls_.r = workspace.take<double>(n);
  balls_.caller = workspace.take<uint32_t>(n);
  scratch_slots_ = workspace.take<uint32_t>(CubeTable::slots_for(n));
  scratch_links_ = workspace.take<uint32_t>(n);
}

void CubeGrid::clear() {
  balls_.n = 0;
  balls_.lattice = {};
  balls_.probe_steps = 0;
  balls_.largest_radius = 0;
  side_ = 1;
  table_.clear(0);
  first_ball_[0] = 0;
}

Status CubeGrid::build(const BallInput &input, uint32_t &first_bad) {
  clear();
  BallRounding rounding;
  if (const Status status = rounding.prepare(input, first_bad); status != Status::ok) return status;

  // Every ball is rounded twice, once to know r_max and hence the cubes, once to be stored: cheaper than a second copy.
  int64_t largest = 0;
  exact::LatticeBall ball;
  for (uint32_t i = 0; i < input.n; ++i) {
    if (const Status status = rounding.round(i, ball); status != Status::ok) {
      first_bad = i;
      return status;
    }
    if (ball.radius > largest) largest = ball.radius;
  }
  side_ = largest > 0 ? 2 * largest : 1;
  balls_.n = input.n;
  balls_.lattice = rounding.lattice();
  balls_.probe_steps = rounding.probe_steps();
  balls_.largest_radius = largest;

  // Count sort by cube number, cubes numbered in the order of their first ball. place_ holds the cube numbers in
  // between.
  table_.clear(input.n);
  for (uint32_t i = 0; i < input.n; ++i) {
    static_cast<void>(rounding.round(i, ball));
    const uint32_t before = table_.count();
    const uint32_t cube = table_.find_or_insert(cube_at(ball.centre, side_));
    if (table_.count() != before) first_ball_[cube + 1] = 0;
    ++first_ball_[cube + 1];
    place_[i] = cube;
  }
  first_ball_[0] = 0;
  for (uint32_t cube = 0; cube < table_.count(); ++cube) first_ball_[cube + 1] += first_ball_[cube];
  for (uint32_t i = 0; i < input.n; ++i) {
    static_cast<void>(rounding.round(i, ball));
    const uint32_t place = first_ball_[place_[i]]++;
    balls_.store(place, ball);
    place_[i] = place;
  }
  // The running starts have become the ends: shift them back by one cube.
  for (uint32_t cube = table_.count(); cube > 0; --cube) first_ball_[cube] = first_ball_[cube - 1];
  first_ball_[0] = 0;
  return Status::ok;
}

CubeBlock CubeGrid::block_around(const CubeCoordinates &centre) const {
  CubeBlock block;
  for (int64_t dz = -1; dz <= 1; ++dz) {
    for (int64_t dy = -1; dy <= 1; ++dy) {
      for (int64_t dx = -1; dx <= 1; ++dx) {
        const uint32_t cube = table_.find({centre.x + dx, centre.y + dy, centre.z + dz});
        if (cube != no_id) block.range[block.ranges++] = balls_in(cube);
      }
    }
  }
  sort_in_place(Span<BallRange>(block.range, block.ranges),
                [](const BallRange &a, const BallRange &b) { return a.first < b.first; });
  uint32_t joined = 0;
  for (uint32_t k = 0; k < block.ranges; ++k) {
    if (joined > 0 && block.range[joined - 1].last == block.range[k].first) {
      block.range[joined - 1].last = block.range[k].last;
    } else {
      block.range[joined++] = block.range[k];
    }
  }
  block.ranges = joined;
  return block;
}

}  // namespace hsp
