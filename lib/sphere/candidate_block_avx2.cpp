#include "sphere/candidate_block.hpp"

#if HSP_AVX2
#include "core/avx2_lanes.hpp"

namespace hsp {
namespace {

// The first `count` of eight numbers from p on, less an origin.
Floats relative(const double *p, uint32_t count, Doubles origin) {
  if (count >= 8) return to_floats(Doubles::load(p) - origin, Doubles::load(p + 4) - origin);
  const Doubles low = Doubles::load_first(p, count);
  const Doubles high = count > 4 ? Doubles::load_first(p + 4, count - 4) : Doubles::all(0.0);
  return to_floats(low - origin, high - origin);
}

}  // namespace

void add_candidates(CandidateBlock &block, const BallArrays &balls, uint32_t first, uint32_t last,
                    const double (&centre)[3]) {
  const Doubles x = Doubles::all(centre[0]), y = Doubles::all(centre[1]), z = Doubles::all(centre[2]);
  for (uint32_t j = first; j < last; j += 8) {
    const uint32_t to = block.count + (j - first);
    relative(balls.x + j, last - j, x).store(block.x + to);
    relative(balls.y + j, last - j, y).store(block.y + to);
    relative(balls.z + j, last - j, z).store(block.z + to);
    relative(balls.r + j, last - j, Doubles::all(0.0)).store(block.r + to);
    (Integers::ascending() + Integers::all(j)).store(block.ball + to);
  }
  block.count += last - first;
}

void end_candidates(CandidateBlock &block) {
  const Floats zero = Floats::all(0.0F);
  Floats::all(0x1p60F).store(block.x + block.count);
  zero.store(block.y + block.count);
  zero.store(block.z + block.count);
  zero.store(block.r + block.count);
}

uint32_t near_candidates(const CandidateBlock &block, uint32_t own, uint32_t *near, uint32_t most, uint32_t &earlier) {
  const float *const xs = block.x, *const ys = block.y, *const zs = block.z, *const rs = block.r;
  const uint32_t *const ids = block.ball;
  const Floats x = Floats::all_of(xs + own), y = Floats::all_of(ys + own), z = Floats::all_of(zs + own),
               r = Floats::all_of(rs + own);
  const Floats margin = Floats::all(block.margin);
  uint32_t found = 0;
  const auto near_lanes = [=](uint32_t c) {
    const Floats dx = Floats::load(xs + c) - x, dy = Floats::load(ys + c) - y, dz = Floats::load(zs + c) - z,
                 sum = Floats::load(rs + c) + r;
    return not_less(margin, fused(dx, dx, fused(dy, dy, minus_fused(sum, sum, dz * dz))));
  };
  const auto keep = [&](uint32_t c, LaneBits chosen) {
    store_front(near + found, Integers::load(ids + c), FrontOrder::of_eight(chosen));
    found += ones(chosen);
  };
  // What stands behind the last one is near to nothing.
  const auto keep_near = [&](uint32_t first, uint32_t last) {
    for (uint32_t c = first; c < last && found <= most; c += 8) keep(c, near_lanes(c));
  };
  const uint32_t with_own = own & ~7U;
  keep_near(0, with_own);
  earlier = found;
  if (found > most) return found;
  const LaneBits own_lane = 1U << (own - with_own);
  const LaneBits chosen = near_lanes(with_own) & ~own_lane;
  keep(with_own, chosen);
  earlier += ones(chosen & (own_lane - 1U));
  keep_near(with_own + 8, block.count);
  return found;
}

}  // namespace hsp
#endif
