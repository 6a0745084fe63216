#include "model/cube_index.hpp"

namespace hsp {
namespace {

// Rounds the balls to floats relative to the middle of the box, unless some are too far from it.
void round_balls(const BallSet &balls, Span<float> rounded, QueryGrid &grid) {
  double extent = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    // The middle is the lower wall of the middle cube. With a directory there are few cubes, so that this is exact.
    const double before = static_cast<double>(static_cast<int64_t>(grid.size[axis]) / 2);
    grid.middle[axis] = (grid.low[axis] + before) * grid.side;
    const double behind = (grid.size[axis] - before) * grid.side;
    extent = behind > extent ? behind : extent;
  }
  grid.middle[3] = 0.0;
  grid.extent = extent;
  if (extent > most_extent_of_reach * grid.largest_radius) return;
  const double *const middle = grid.middle;
  float *to = rounded.data();
  for (uint32_t i = 0; i < balls.n; ++i, to += 4) {
    to[0] = static_cast<float>(balls.x[i] - middle[0]);
    to[1] = static_cast<float>(balls.y[i] - middle[1]);
    to[2] = static_cast<float>(balls.z[i] - middle[2]);
    to[3] = static_cast<float>(balls.r[i]);
  }
  for (uint32_t k = 0; k < 4 * BallSet::read_behind; ++k) to[k] = 0.0F;
  grid.rounded = rounded.data();
}

}  // namespace

void CubeIndex::carve(Workspace &workspace, uint32_t n) {
  slots_ = CubeSlots(workspace.take<uint32_t>(CubeSlots::slots_for(n)));
  cells_ = workspace.take<uint32_t>(CubeSlots::slots_for(n));
  if (rounds_balls) rounded_ = workspace.take<float>(4 * (static_cast<uint64_t>(n) + BallSet::read_behind));
}

Span<uint32_t> CubeIndex::end() const {
  forget(cells_);
  forget(rounded_);
  return rounds_balls ? Span(reinterpret_cast<uint32_t *>(rounded_.data()), rounded_.size()) : cells_;
}

void CubeIndex::build(const OrderedBalls &order, bool rounds) {
  end();  // also ends other uses of the memory
  slots_.insert_all(order.cubes(), order.cube_list().cube_of(), cells_);
  build_rows(order, rounds);
}

void CubeIndex::build_rows(const OrderedBalls &order, bool rounds) {
  if (has_row_directories) rows_.build(order.cube_list(), order.first_ball(), cells_);
  QueryGrid *const grid = queries_.get();
  if (grid == nullptr) return;
  *grid = {};
  if (!rows_.is_there()) return;
  const BallSet &balls = order.balls();
  rows_.describe(*grid);
  grid->side = static_cast<double>(order.side());
  grid->inverse_side = 1.0 / grid->side;
  grid->largest_radius = static_cast<double>(balls.largest_radius);
  grid->factor = balls.lattice.factor();
  if (rounds) round_balls(balls, rounded_, *grid);
}

}  // namespace hsp
