#include "sphere/cube_candidates.hpp"

#include "model/meeting.hpp"
#include "sphere/pair_sweep.hpp"

namespace hsp {

void CandidatesInLanes::carve(Workspace &workspace, uint32_t neighbours, uint32_t balls) {
  target_ = workspace.target();
  // There is no limit for the balls of a cube and those around it. Their volume is some six times that in which a
  // ball's neighbours lie.
  const uint64_t most = 8 * (uint64_t{neighbours <= PairSweep::most_caps ? neighbours : PairSweep::most_caps} + 32);
  block_.room = most < balls ? static_cast<uint32_t>(most) : balls;
  const uint64_t entries = uint64_t{block_.room} + CandidateBlock::spare;
  block_.x = workspace.take<float>(entries).data();
  block_.y = workspace.take<float>(entries).data();
  block_.z = workspace.take<float>(entries).data();
  block_.r = workspace.take<float>(entries).data();
  block_.ball = workspace.take<uint32_t>(entries).data();
}

bool CandidatesInLanes::start_cube(const CubeGrid &grid, uint32_t cube, uint32_t first_own, const CubeBlock &block) {
  const CubeCoordinates &at = grid.cube_list().coordinates(cube);
  const auto middle = [&grid](int64_t c) { return static_cast<double>(c * grid.side() + grid.side() / 2); };
  const double centre[3] = {middle(at.x), middle(at.y), middle(at.z)};
  return start_block(grid.balls(), block, first_own, centre, static_cast<double>(grid.side()));
}

bool CandidatesInLanes::start_block(const BallSet &balls, const CubeBlock &block, uint32_t first_own,
                                    const double (&centre)[3], double side) {
  uint32_t total = 0;
  for (uint32_t k = 0; k < block.ranges; ++k) total += block.range[k].last - block.range[k].first;
  if (total > block_.room) return false;
  block_.doubt = static_cast<float>(doubt_nearby(side));
  block_.count = 0;
  first_own_ = first_own;
  const BallArrays arrays = arrays_of(balls);
  for (uint32_t k = 0; k < block.ranges; ++k) {
    const BallRange range = block.range[k];
    if (range.first <= first_own && first_own < range.last) own_rank_ = block_.count + (first_own - range.first);
    add_candidates(target_, block_, arrays, range.first, range.last, centre);
  }
  end_candidates(target_, block_);
  return true;
}

}  // namespace hsp
