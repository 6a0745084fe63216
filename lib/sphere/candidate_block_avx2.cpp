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

uint32_t near_candidates(const CandidateBlock &block, uint32_t own, uint32_t first, uint32_t last, uint32_t *near,
                         uint32_t most) {
  const Floats x = Floats::all_of(block.x + own), y = Floats::all_of(block.y + own), z = Floats::all_of(block.z + own),
               r = Floats::all_of(block.r + own);
  const Floats margin = Floats::all(block.margin);
  uint32_t found = 0;
  for (uint32_t c = first; c < last; c += 8) {
    const Floats dx = Floats::load(block.x + c) - x, dy = Floats::load(block.y + c) - y,
                 dz = Floats::load(block.z + c) - z, sum = Floats::load(block.r + c) + r;
    const Floats excess = fused(dx, dx, fused(dy, dy, minus_fused(sum, sum, dz * dz)));
    const LaneBits chosen = not_less(margin, excess) & first_lanes(last - c);
    store_front(near + found, Integers::load(block.ball + c), FrontOrder::of_eight(chosen));
    found += ones(chosen);
    if (found > most) return found;
  }
  return found;
}

}  // namespace hsp
#endif
