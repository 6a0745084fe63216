#include "view/covered_balls.hpp"

#include "model/meeting.hpp"

namespace hsp {

void CoveredBalls::carve(Workspace &workspace, uint32_t caps) {
  const uint32_t room = small_code ? 0 : caps;
  caps_.carve(workspace, room);
  workspace.take_each(room, order_, state_);
}

bool CoveredBalls::contains(uint32_t ball) {
  caps_.gather_given(grid_->balls(), ball, take_some_near(ball));
  if (caps_.contained) return true;
  return caps_.count > 0 && !ExposedCaps(order_, state_).find(ExposedCaps::Part::sphere, caps_);
}

// Where there is no room for all, every second one, every fourth, .. of the grid's order.
uint32_t CoveredBalls::take_some_near(uint32_t ball) {
  const BallSet &balls = grid_->balls();
  const CubeBlock block = grid_->block_around(grid_->cube_at(balls.ball(ball).centre));
  const Span<uint32_t> taken = caps_.ball.part(0, caps_.capacity());
  uint32_t count = 0, met = 0, step = 1;
  for (uint32_t range = 0; range < block.ranges; ++range) {
    for (uint32_t j = block.range[range].first; j < block.range[range].last; ++j) {
      const bool meets = meet(balls.x[j] - balls.x[ball], balls.y[j] - balls.y[ball], balls.z[j] - balls.z[ball],
                              balls.r[j] + balls.r[ball]);
      if (!meets || j == ball || met++ % step != 0) continue;
      if (count == taken.size()) {
        count = 0;
        for (uint32_t k = 0; k < taken.size(); k += 2) taken[count++] = taken[k];
        step *= 2;
        if ((met - 1) % step != 0) continue;
      }
      if (count < taken.size()) taken[count++] = j;
    }
  }
  return count;
}

}  // namespace hsp
