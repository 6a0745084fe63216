#include "model/rounded_block.hpp"

#include "model/meeting_lanes.hpp"

namespace hsp::HSP_TARGET {
namespace {

// Decides what floats leave open, lane by lane. Out of line, as it is rare.
[[gnu::noinline, gnu::cold]] LaneBits decided_by_integers(const RoundedBlock &block, const QueryArrays &balls,
                                                          uint32_t i, uint32_t from, LaneBits doubtful, LaneBits meet) {
  return decided(doubtful, meet, [&](uint32_t lane) {
    const BallRange *range = block.range;
    uint32_t offset = from + lane;
    for (; offset >= range->last - range->first; ++range) offset -= range->last - range->first;
    const uint32_t j = range->first + offset;
    return meet_exactly(balls.x[j] - balls.x[i], balls.y[j] - balls.y[i], balls.z[j] - balls.z[i],
                        balls.r[j] + balls.r[i]);
  });
}

// Tests one ball against the balls of the block.
class BlockQuery {
 public:
  BlockQuery(const RoundedBlock &block, const QueryArrays &balls, uint32_t i)
      : block_(block), balls_(balls), i_(i), doubt_(Floats::all(block.doubt)) {
    const float *const own = block.rounded + 4 * size_t{i};
    ball_ = {Floats::all(own[0]), Floats::all(own[1]), Floats::all(own[2]), Floats::all(own[3])};
  }

  // The balls of the block from number c on, one in each lane, that meet the ball.
  LaneBits meeting(uint32_t c) const {
    const Floats excess = ball_.excess(Floats::load(block_.x + c), Floats::load(block_.y + c),
                                       Floats::load(block_.z + c), Floats::load(block_.r + c));
    const LaneBits doubtful = not_greater(magnitude(excess), doubt_);
    if (doubtful != 0) [[unlikely]]
      return decided_by_integers(block_, balls_, i_, c, doubtful, negative(excess));
    return negative(excess);
  }

 private:
  const RoundedBlock &block_;
  const QueryArrays &balls_;
  const uint32_t i_;
  FloatBall ball_;
  const Floats doubt_;
};

}  // namespace

bool fill_block(RoundedBlock &block, const QueryGrid &grid, const QueryArrays &balls, const BallRange *ranges,
                uint32_t range_count) {
  const float *const rounded = grid.rounded;
  uint32_t count = 0;
  for (uint32_t k = 0; k < range_count; ++k) {
    const uint32_t first = ranges[k].first, last = ranges[k].last;
    if (last - first > RoundedBlock::room - count) return false;
    uint32_t to = count;
    // Nearly always this runs once or twice.
    for (uint32_t j = first; j < last; j += Floats::lanes, to += Floats::lanes) {
      const FourOfEach four = FourOfEach::load(rounded + 4 * size_t{j});
      four.a.store(block.x + to);
      four.b.store(block.y + to);
      four.c.store(block.z + to);
      four.d.store(block.r + to);
      Integers::load(balls.caller + j).store(block.caller + to);
    }
    block.range[k] = ranges[k];
    count += last - first;
  }
  // Lanes after the last one meet nothing.
  store_far_balls(block.x + count, block.y + count, block.z + count, block.r + count);
  block.count = count;
  block.rounded = rounded;
  block.doubt = static_cast<float>(doubt_within(grid.extent, 2.0 * grid.largest_radius));
  return true;
}

uint32_t count_in_block(const RoundedBlock &block, const QueryArrays &balls, uint32_t i) {
  const BlockQuery query(block, balls, i);
  const uint32_t count = block.count;
  uint32_t found = 0;
  for (uint32_t c = 0; c < count; c += Floats::lanes) found += ones(query.meeting(c));
  return found;
}

void find_others_in_block(const RoundedBlock &block, const QueryArrays &balls, uint32_t i, QueryHits &hits) {
  const BlockQuery query(block, balls, i);
  const Integers own = Integers::all(balls.caller[i]);
  const uint32_t count = block.count;
  uint32_t found = 0;
  for (uint32_t c = 0; c < count; c += Floats::lanes) {
    const Integers ids = Integers::load(block.caller + c);
    const LaneBits meet = query.meeting(c) & ~equal(ids, own);
    store_front(hits.ids + (found < QueryHits::room ? found : QueryHits::room), ids, FrontOrder::of(meet));
    found += ones(meet);
  }
  hits.count = found;
}

}  // namespace hsp::HSP_TARGET
