#include "sphere/candidate_block.hpp"

#include "model/meeting_lanes.hpp"

namespace hsp::HSP_TARGET {
namespace {

// Collects the candidates near one of them.
class NearLanes {
 public:
  NearLanes(const CandidateBlock &block, uint32_t own, uint32_t *near, uint32_t most)
      : ball_{Floats::all_of(block.x + own), Floats::all_of(block.y + own), Floats::all_of(block.z + own),
              Floats::all_of(block.r + own)},
        doubt_(Floats::all(block.doubt)),
        block_(block),
        near_(near),
        most_(most) {}

  uint32_t found() const { return found_; }
  // Which candidates are near, from c on, as many as there are lanes.
  LaneBits lanes(uint32_t c) const {
    return not_less(doubt_, ball_.excess(Floats::load(block_.x + c), Floats::load(block_.y + c),
                                         Floats::load(block_.z + c), Floats::load(block_.r + c)));
  }
  void keep(uint32_t c, LaneBits chosen) {
    store_front(near_ + found_, Integers::load(block_.ball + c), FrontOrder::of(chosen));
    found_ += ones(chosen);
  }
  // Lanes after the last candidate are near to nothing.
  void keep_near(uint32_t first, uint32_t last) {
    for (uint32_t c = first; c < last && found_ <= most_; c += Floats::lanes) keep(c, lanes(c));
  }

 private:
  const FloatBall ball_;
  const Floats doubt_;
  const CandidateBlock block_;
  uint32_t *const near_;
  const uint32_t most_;
  uint32_t found_ = 0;
};

}  // namespace

void set_candidates(CandidateBlock &block, const BallArrays &balls, const BallRange *range, uint32_t ranges,
                    const double (&centre)[3]) {
  const CandidateBlock to = block;
  uint32_t count = 0;
  for (uint32_t k = 0; k < ranges; ++k) {
    const auto [first, last] = range[k];
    for (uint32_t j = first, c = count; j < last; j += Floats::lanes, c += Floats::lanes) {
      relative(balls.x + j, centre[0]).store(to.x + c);
      relative(balls.y + j, centre[1]).store(to.y + c);
      relative(balls.z + j, centre[2]).store(to.z + c);
      to_floats(Doubles::load(balls.r + j), Doubles::load(balls.r + j + Doubles::lanes)).store(to.r + c);
      (Integers::ascending() + Integers::all(j)).store(to.ball + c);
    }
    count += last - first;
  }
  store_far_balls(to.x + count, to.y + count, to.z + count, to.r + count);
  block.count = count;
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

uint32_t count_candidates(const CandidateBlock &block, uint32_t own) {
  const NearLanes around(block, own, nullptr, 0);
  uint32_t found = 0;
  for (uint32_t c = 0; c < block.count; c += Floats::lanes) found += ones(around.lanes(c));
  return found;
}

uint32_t later_candidates(const CandidateBlock &block, uint32_t own, uint32_t *near, uint32_t most) {
  NearLanes around(block, own, near, most);
  around.keep_near(own + 1, block.count);
  return around.found();
}

}  // namespace hsp::HSP_TARGET
