#include "model/pair_block.hpp"

#include "model/meeting_lanes.hpp"

namespace hsp::HSP_TARGET {
namespace {

// Decides what floats leave open, lane by lane. Out of line, as it is rare.
[[gnu::noinline, gnu::cold]] LaneBits decided_by_integers(const PairBlock &block, const QueryArrays &balls, uint32_t i,
                                                          uint32_t from, LaneBits doubtful, LaneBits meet) {
  return decided(doubtful, meet, [&](uint32_t lane) {
    const uint32_t j = block.rank[from + lane];
    return meet_exactly(balls.x[j] - balls.x[i], balls.y[j] - balls.y[i], balls.z[j] - balls.z[i],
                        balls.r[j] + balls.r[i]);
  });
}

}  // namespace

uint32_t add_to_block(PairBlock &block, const QueryArrays &balls, const BallRange &range) {
  const uint32_t left = PairBlock::room - block.count;
  const uint32_t last = range.last - range.first > left ? range.first + left : range.last;
  uint32_t to = block.count;
  for (uint32_t j = range.first; j < last; j += Floats::lanes, to += Floats::lanes) {
    relative(balls.x + j, block.centre[0]).store(block.x + to);
    relative(balls.y + j, block.centre[1]).store(block.y + to);
    relative(balls.z + j, block.centre[2]).store(block.z + to);
    to_floats(Doubles::load(balls.r + j), Doubles::load(balls.r + j + Doubles::lanes)).store(block.r + to);
    Integers::load(balls.caller + j).store(block.caller + to);
    (Integers::ascending() + Integers::all(j)).store(block.rank + to);
  }
  block.count += last - range.first;
  // Lanes after the last one meet nothing.
  store_far_balls(block.x + block.count, block.y + block.count, block.z + block.count, block.r + block.count);
  return last;
}

uint32_t met_in_block(const PairBlock &block, const QueryArrays &balls, uint32_t i, uint32_t from, uint32_t *met) {
  const FloatBall ball{Floats::all(static_cast<float>(balls.x[i] - block.centre[0])),
                       Floats::all(static_cast<float>(balls.y[i] - block.centre[1])),
                       Floats::all(static_cast<float>(balls.z[i] - block.centre[2])),
                       Floats::all(static_cast<float>(balls.r[i]))};
  const Floats doubt = Floats::all(block.doubt);
  const uint32_t count = block.count;
  uint32_t found = 0;
  for (uint32_t c = from; c < count; c += Floats::lanes) {
    const Floats excess = ball.excess(Floats::load(block.x + c), Floats::load(block.y + c), Floats::load(block.z + c),
                                      Floats::load(block.r + c));
    LaneBits meet = negative(excess);
    const LaneBits doubtful = not_greater(magnitude(excess), doubt);
    if (doubtful != 0) [[unlikely]]
      meet = decided_by_integers(block, balls, i, c, doubtful, meet);
    store_front(met + found, Integers::load(block.caller + c), FrontOrder::of(meet));
    found += ones(meet);
  }
  return found;
}

}  // namespace hsp::HSP_TARGET
