#include "sphere/cube_candidates.hpp"

#include "model/meeting.hpp"

namespace hsp {

void CandidatesInLanes::start(Span<uint32_t> memory, Target target) {
  target_ = target;
  memory_ = memory;
  const uint32_t most = memory.size() / number_of_arrays / 8 * 8;
  block_.room = most > CandidateBlock::spare ? most - CandidateBlock::spare : 0;
  if (block_.room == 0) return;
  uint32_t *const words = memory.data();
  block_.x = reinterpret_cast<float *>(words);
  block_.y = reinterpret_cast<float *>(words + most);
  block_.z = reinterpret_cast<float *>(words + 2 * most);
  block_.r = reinterpret_cast<float *>(words + 3 * most);
  block_.ball = words + 4 * most;
}

void CandidatesInLanes::end() {
  forget(memory_);
  memory_ = {};
  block_ = {};
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
  for (uint32_t k = 0; k < block.ranges; ++k) {
    const BallRange range = block.range[k];
    if (range.first <= first_own && first_own < range.last) own_rank_ = total + (first_own - range.first);
    total += range.last - range.first;
  }
  if (total > block_.room) return false;
  block_.doubt = static_cast<float>(doubt_nearby(side));
  first_own_ = first_own;
  set_candidates(target_, block_, arrays_of(balls), block.range, block.ranges, centre);
  return true;
}

}  // namespace hsp
