#include "view/covered_balls.hpp"

#include "model/meeting.hpp"

namespace hsp {

void CoveredBalls::carve(Workspace &workspace, uint32_t caps) {
  const uint32_t room = small_code ? 0 : caps;
  caps_.carve(workspace, room);
  workspace.take_each(room, order_, state_);
}

bool CoveredBalls::contains(uint32_t ball) {
  const BallSet &balls = grid_->balls();
  const CubeBlock block = grid_->block_around(grid_->cube_at(balls.ball(ball).centre));
  uint32_t count = 0;
  for (uint32_t range = 0; range < block.ranges; ++range) {
    for (uint32_t j = block.range[range].first; j < block.range[range].last; ++j) {
      const bool meets = meet(balls.x[j] - balls.x[ball], balls.y[j] - balls.y[ball], balls.z[j] - balls.z[ball],
                              balls.r[j] + balls.r[ball]);
      if (!meets || j == ball) continue;
      if (count == room_) {
        if (!keep_exposed(ball, count)) return true;
        count = caps_.count;
        all_known_ = 4 * uint64_t{count} < 3 * uint64_t{room_};
        if (!all_known_) return false;
      }
      caps_.ball[count++] = j;
    }
  }
  all_known_ = true;
  return !keep_exposed(ball, count);
}

// Keeps of the first `count` balls in caps_.ball those whose circles may have a free part outside the others. False if
// nothing is left of the sphere.
bool CoveredBalls::keep_exposed(uint32_t ball, uint32_t count) {
  caps_.gather_given(grid_->balls(), ball, count);
  return !caps_.contained &&
         (caps_.count == 0 || ExposedCaps(order_, state_).keep(ExposedCaps::Part::sphere, caps_, 0));
}

}  // namespace hsp
