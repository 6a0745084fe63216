#include "model/pair_block.hpp"

#include "lanes/words.hpp"

namespace hsp::HSP_TARGET {
namespace {

inline Floats relative(const double *p, double origin) {
  const Doubles from = Doubles::all(origin);
  return to_floats(Doubles::load(p) - from, Doubles::load(p + Doubles::lanes) - from);
}

// For what floats leave open, lane by lane. Apart, as it is rare.
[[gnu::noinline]] LaneBits decided(const PairBlock &block, const QueryArrays &balls, uint32_t i, uint32_t from,
                                   LaneBits doubtful) {
  LaneBits meet = 0;
  for (; doubtful != 0; doubtful &= doubtful - 1) {
    const uint32_t lane = lowest(doubtful), j = block.rank[from + lane];
    const bool hit = meet_exactly(balls.x[j] - balls.x[i], balls.y[j] - balls.y[i], balls.z[j] - balls.z[i],
                                  balls.r[j] + balls.r[i]);
    meet |= static_cast<LaneBits>(hit) << lane;
  }
  return meet;
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
  Floats::all(0x1p60F).store(block.x + block.count);
  Floats::all(0.0F).store(block.y + block.count);
  Floats::all(0.0F).store(block.z + block.count);
  Floats::all(0.0F).store(block.r + block.count);
  return last;
}

uint32_t met_in_block(const PairBlock &block, const QueryArrays &balls, uint32_t i, uint32_t from, uint32_t *met) {
  const Floats x = Floats::all(static_cast<float>(balls.x[i] - block.centre[0]));
  const Floats y = Floats::all(static_cast<float>(balls.y[i] - block.centre[1]));
  const Floats z = Floats::all(static_cast<float>(balls.z[i] - block.centre[2]));
  const Floats r = Floats::all(static_cast<float>(balls.r[i]));
  const Floats above = Floats::all(block.margin), below = -above;
  const uint32_t count = block.count;
  uint32_t found = 0;
  for (uint32_t c = from; c < count; c += Floats::lanes) {
    const Floats dx = Floats::load(block.x + c) - x, dy = Floats::load(block.y + c) - y,
                 dz = Floats::load(block.z + c) - z, sum = Floats::load(block.r + c) + r;
    const Floats excess = fused(dx, dx, fused(dy, dy, minus_fused(sum, sum, dz * dz)));
    LaneBits meet = greater(below, excess);
    const LaneBits doubtful = (meet | greater(excess, above)) ^ all_lanes;
    if (doubtful != 0) [[unlikely]]
      meet |= decided(block, balls, i, c, doubtful);
    store_front(met + found, Integers::load(block.caller + c), FrontOrder::of(meet));
    found += ones(meet);
  }
  return found;
}

}  // namespace hsp::HSP_TARGET
