#include "view/view_builder.hpp"

#include "model/block_sweep.hpp"
#include "view/piece_arcs.hpp"

namespace hsp {

void ViewBuilder::carve(Workspace &workspace, const ViewLimits &limits) {
  limit(limits);
  structure_.carve(workspace, limits);
  hidden_.carve(workspace, limits.balls);
  piece_.carve(workspace, limits.neighbours);
  cut_ = FixedVector<PieceRecord>(workspace.take<PieceRecord>(limits.balls));
  workspace.take_each(limits.balls, visible_, scratch_, keys_);
}

// Balls of radius 0 have no front, and balls without faces are invisible. The pieces of other balls cover them, so that
// they need not cut anything either.
bool ViewBuilder::choose_balls(const CubeGrid &grid, const Boundary *boundary, bool all_balls, Patience &patience) {
  const BallSet &balls = grid.balls();
  for (uint32_t i = 0; i < balls.n; ++i) {
    const bool has_face = boundary == nullptr || boundary->is_exposed(i);
    visible_[i] = balls.r[i] > 0.0 && has_face ? 1 : 0;
  }
  return all_balls || hidden_.hide(grid, structure_.frame, visible_, patience);
}

// Cube by cube, so that the block of neighbouring cubes is looked up once for all balls of a cube.
bool ViewBuilder::cut_pieces(const CubeGrid &grid, const Boundary *boundary, Patience &patience) {
  const BallSet &balls = grid.balls();
  const exact::Vector &direction = structure_.frame.direction;
  cut_.clear();
  structure_.loops.clear();
  structure_.arcs.clear();
  needed_.neighbours = 0;
  BlockSweep sweep(grid);
  uint64_t met = 0;  // how many balls the ball before has met: those around the next one are not known yet
  for (uint32_t cube = 0; cube < grid.cubes(); ++cube) {
    const BallRange own = grid.balls_in(cube);
    for (uint32_t i = own.first; i < own.last; ++i) {
      if (visible_[i] == 0) continue;
      const CubeBlock &block = sweep.block_around(cube);
      if (!patience.allows(5000 + (500 + met) * met)) return false;
      if (kind_ == PieceKind::outside_all) {
        piece_.cut_faces(balls, block, *boundary, direction, i);
      } else {
        piece_.cut_hemisphere(balls, block, direction, i, [&](uint32_t other) {
          return visible_[other] != 0 && is_farther(balls, direction, other, i);
        });
      }
      met = piece_.caps().met;
      add_piece(balls);
    }
  }
  return true;
}

void ViewBuilder::add_piece(const BallSet &balls) {
  if (piece_.caps().contained) return;
  needed_.neighbours = larger_count(needed_.neighbours, piece_.caps().met);
  // Once a ball has more neighbours than there is room for, the rest is only counted.
  if (needed_.neighbours > limits_.neighbours) return;
  if (piece_.half_edges().empty() && piece_.circles().empty()) return;
  const uint32_t first_loop = static_cast<uint32_t>(structure_.loops.required());
  const uint32_t first_arc = static_cast<uint32_t>(structure_.arcs.required());
  add_loops(balls, piece_, structure_);
  cut_.push({piece_.caps().origin, first_loop, static_cast<uint32_t>(structure_.loops.required()) - first_loop,
             first_arc, static_cast<uint32_t>(structure_.arcs.required()) - first_arc});
}

bool ViewBuilder::sort_pieces(const BallSet &balls, Patience &patience) {
  const Span<DepthKey> keys = keys_.part(0, cut_.size());
  for (uint32_t k = 0; k < keys.size(); ++k) keys[k] = {0.0, cut_[k].ball, k};
  sort_by_depth(balls, structure_.frame, keys, scratch_.part(0, keys.size()), patience);
  structure_.pieces.clear();
  for (const DepthKey &key : keys) structure_.pieces.push(cut_[key.item]);
  return patience.allows(0);
}

Status ViewBuilder::build(const CubeGrid &grid, const Boundary *boundary, const ViewRequest &request,
                          Patience patience) {
  const BallSet &balls = grid.balls();
  needed_ = {};
  kind_ = request.kind;
  if (const Status status = look_from(request.direction, structure_.frame); status != Status::ok) return status;
  needed_.balls = balls.n;
  if (balls.n > limits_.balls) return Status::capacity;
  centre_on(balls, structure_.frame);
  if (!choose_balls(grid, boundary, request.all_balls, patience) || !cut_pieces(grid, boundary, patience))
    return Status::stopped;
  if (needed_.neighbours > limits_.neighbours) return Status::capacity;
  needed_.arcs = clamped_count(structure_.arcs.required());
  if (structure_.arcs.overflowed()) return Status::capacity;
  return sort_pieces(balls, patience) ? Status::ok : Status::stopped;
}

}  // namespace hsp
