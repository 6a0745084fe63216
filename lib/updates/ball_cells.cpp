#include "updates/ball_cells.hpp"

namespace hsp {

void BallCells::carve(Workspace &workspace, uint32_t balls) {
  first_ = workspace.take<uint32_t>(CubeTable::slots_for(balls));
  next_ = workspace.take<uint32_t>(balls);
  linear_ = workspace.take<uint64_t>(balls);
}

void BallCells::clear(uint32_t balls, int64_t side) {
  balls_ = balls;
  side_ = side;
  used_ = static_cast<uint32_t>(CubeTable::slots_for(balls));
  for (uint32_t &first : first_.part(0, used_)) first = no_id;
}

void BallCells::insert(uint32_t ball, const exact::Vector &centre) {
  linear_[ball] = linear_hash(CubeAxis(side_).cube_at(centre));
  uint32_t &first = first_[bucket_of(linear_[ball])];
  next_[ball] = first;
  first = ball;
}

void BallCells::remove(uint32_t ball) {
  uint32_t *at = &first_[bucket_of(linear_[ball])];
  while (*at != ball) at = &next_[*at];
  *at = next_[ball];
}

}  // namespace hsp
