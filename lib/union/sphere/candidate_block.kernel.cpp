#include "sphere/candidate_block.hpp"
#include "lanes/words.hpp"

namespace hsp::HSP_TARGET {
namespace {

// The first `count` numbers from p on, less an origin, and zeros.
Floats relative(const double *p, uint32_t count, Doubles origin) {
  if (count >= Floats::lanes) return to_floats(Doubles::load(p) - origin, Doubles::load(p + Doubles::lanes) - origin);
  const Doubles low = Doubles::load_first(p, count);
  const Doubles high =
      count > Doubles::lanes ? Doubles::load_first(p + Doubles::lanes, count - Doubles::lanes) : Doubles::all(0.0);
  return to_floats(low - origin, high - origin);
}

// Collects those near one candidate.
class NearLanes {
 public:
  NearLanes(const CandidateBlock &block, uint32_t own, uint32_t *near, uint32_t most)
      : x_(Floats::all_of(block.x + own)),
        y_(Floats::all_of(block.y + own)),
        z_(Floats::all_of(block.z + own)),
        r_(Floats::all_of(block.r + own)),
        margin_(Floats::all(block.margin)),
        block_(block),
        near_(near),
        most_(most) {}

  uint32_t found() const { return found_; }
  // Of the candidates from c on, as many as there are lanes.
  LaneBits lanes(uint32_t c) const {
    const Floats dx = Floats::load(block_.x + c) - x_, dy = Floats::load(block_.y + c) - y_,
                 dz = Floats::load(block_.z + c) - z_, sum = Floats::load(block_.r + c) + r_;
    return not_less(margin_, fused(dx, dx, fused(dy, dy, minus_fused(sum, sum, dz * dz))));
  }
  void keep(uint32_t c, LaneBits chosen) {
    store_front(near_ + found_, Integers::load(block_.ball + c), FrontOrder::of(chosen));
    found_ += ones(chosen);
  }
  // Lanes after the last one are near to nothing.
  void keep_near(uint32_t first, uint32_t last) {
    for (uint32_t c = first; c < last && found_ <= most_; c += Floats::lanes) keep(c, lanes(c));
  }

 private:
  const Floats x_, y_, z_, r_, margin_;
  const CandidateBlock block_;
  uint32_t *const near_;
  const uint32_t most_;
  uint32_t found_ = 0;
};

}  // namespace

void add_candidates(CandidateBlock &block, const BallArrays &balls, uint32_t first, uint32_t last,
                    const double (&centre)[3]) {
  const Doubles x = Doubles::all(centre[0]), y = Doubles::all(centre[1]), z = Doubles::all(centre[2]);
  for (uint32_t j = first; j < last; j += Floats::lanes) {
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
  NearLanes around(block, own, near, most);
  const uint32_t with_own = own / Floats::lanes * Floats::lanes;
  around.keep_near(0, with_own);
  earlier = around.found();
  if (around.found() > most) return around.found();
  const LaneBits own_lane = 1U << (own - with_own);
  const LaneBits chosen = around.lanes(with_own) & ~own_lane;
  around.keep(with_own, chosen);
  earlier += ones(chosen & (own_lane - 1U));
  around.keep_near(with_own + Floats::lanes, block.count);
  return around.found();
}

uint32_t later_candidates(const CandidateBlock &block, uint32_t own, uint32_t *near, uint32_t most) {
  NearLanes around(block, own, near, most);
  around.keep_near(own + 1, block.count);
  return around.found();
}

}  // namespace hsp::HSP_TARGET
