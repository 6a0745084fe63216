// Finds the caps that may touch the free part of a sphere with hundreds of caps.
//
// As an example the unit sphere and the caps
//   A   x >= 0.5                     60 degrees around x
//   B   x >= 0.9                     26 degrees around x: inside A, hence discarded
//   C   0.6 x + 0.8 y >= 0.95        18 degrees around a direction 53 degrees from x: it reaches to 71 degrees from x,
//                                    out of A, so that it stays
// One of several copies of A stays. Most discarded caps are inside a much larger one, so large caps are tried first.
#include "sphere/exposed_caps.hpp"

#include <cstring>

namespace hsp {
namespace {

// Balls with one centre follow each other in grid order: all but the outermost of these are dropped. As a copy of a
// plane that has cut goes through vertices, it would stay in doubt. numbers: ascending. Returns those that are left.
Span<const uint32_t> without_copies(const Caps &caps, Span<uint32_t> numbers) {
  const BallSet &balls = caps.balls();
  uint32_t left = 0;
  for (const uint32_t k : numbers) {
    const uint32_t ball = caps.ball[k], last = left > 0 ? caps.ball[numbers[left - 1]] : ball;
    if (balls.x[last] == balls.x[ball]) {
      if (lies_inside(balls, ball, last)) continue;
      if (lies_inside(balls, last, ball)) --left;
    }
    numbers[left++] = k;
  }
  return numbers.part(0, left);
}

}  // namespace

// Every step-th cap, the largest first: if the ball is buried, that is mostly known after few of them.
template <class Real>
Span<const uint32_t> ExposedCaps::order_by_size(const Real *b, uint32_t count, uint32_t step) {
  constexpr uint32_t classes = 64;
  uint32_t start[classes + 1] = {};
  Real least = b[0], most = b[0];
  for (uint32_t k = 0; k < count; k += step) {
    least = b[k] < least ? b[k] : least;
    most = b[k] > most ? b[k] : most;
  }
  const Real scale = classes / (most - least);
  std::memset(state_.data(), not_tried, count);
  for (uint32_t k = 0; k < count; k += step) {
    // The last class has the smallest, and NaN where all are of one size.
    const Real scaled = (b[k] - least) * scale;
    const uint32_t size = scaled < classes ? static_cast<uint32_t>(scaled) : classes - 1;
    state_[k] = static_cast<uint8_t>(not_tried + size);
    ++start[size + 1];
  }
  for (uint32_t c = 0; c < classes; ++c) start[c + 1] += start[c];
  for (uint32_t k = 0; k < count; k += step) order_[start[state_[k] - not_tried]++] = k;
  return order_.part(0, start[classes - 1]);
}

// The caps in states first to last, ascending.
Span<uint32_t> ExposedCaps::in_states(uint32_t count, uint8_t first, uint8_t last) {
  uint32_t found = 0;
  for (uint32_t k = 0; k < count; ++k) {
    uint64_t eight = 0;
    if (count - k >= sizeof eight) {
      std::memcpy(&eight, &state_[k], sizeof eight);
      if ((eight & UINT64_C(0x8080808080808080)) == 0) {
        k += sizeof eight - 1;
        continue;
      }
    }
    if (state_[k] >= first && state_[k] <= last) order_[found++] = k;
  }
  return order_.part(0, found);
}

// For each set of vertices keeps at most one cap whose plane goes through all of them, so that ties are seen. The ball
// of this cap does not lie inside the ball of a cap that stays anyway: such a ball may not count as a tie.
void ExposedCaps::keep_planes_of_ties(const Caps &caps, TiedSets &sets) {
  const Span<const uint32_t> others = in_states(caps.count, has_cut, near_vertex);
  for (uint32_t k = 0; k < caps.count; ++k) {
    if (state_[k] < tied) continue;
    const uint32_t set = state_[k] - tied;
    bool drops = sets.is_kept(set);
    for (uint32_t n = 0; n < others.size() && !drops; ++n) {
      drops = lies_inside(caps.balls(), caps.ball[k], caps.ball[others[n]]);
    }
    state_[k] = drops ? dropped : stays;
    if (!drops) sets.keep(set);
  }
}

bool ExposedCaps::find(Part part, const Caps &caps, const FloatCaps *floats) {
  // Planes that go less deep wait. Where planes nearly agree, as those of nearly equal balls do, the deepest of all is
  // to cut, not one after the other.
  constexpr double deep = 0x1p-5;
  constexpr uint32_t many_refused = 32;
  const uint32_t count = caps.count;
  CellCutting cutting(caps, part, floats != nullptr, state_);
  if (floats == nullptr) {
    if (!cutting.cut_by(order_by_size(caps.b.data(), count, 1), deep)) return false;
  } else {
    // First the largest caps of a sample. Then floats tell of which other caps doubles are to be made: of few, once the
    // deepest have cut.
    constexpr uint32_t first = 2 * CapBatch::most, sample = 8 * CapBatch::most;
    const Span<const uint32_t> largest = order_by_size(floats->b, count, count / sample + 1);
    if (!cutting.cut_by(largest.part(0, largest.size() < first ? largest.size() : first), deep)) return false;
    uint32_t near = 0, deepest = 0;
    for (uint32_t cuts = 0; cuts < 4; ++cuts) {
      near = float_caps_that_may_cut(caps.target, cutting.cell(), *floats, count, order_.data(), deepest);
      if (near <= first || is_tried(deepest)) break;
      if (!cutting.cut_by({&deepest, 1}, 0.0)) return false;
    }
    uint32_t left = 0;
    for (const uint32_t k : order_.part(0, near)) {
      order_[left] = k;
      left += is_tried(k) ? 0U : 1U;
    }
    if (!cutting.cut_by(without_copies(caps, order_.part(0, left)), deep)) return false;
  }
  if (cutting.some_wait() && !cutting.cut_by(in_states(count, waits, waits), 0.0)) return false;
  cutting.drop(in_states(count, has_cut, near_vertex));
  const Span<uint32_t> near = in_states(count, near_vertex, near_vertex);
  if (near.size() >= fewest_ties) {
    const CellTies ties(caps);
    TiedSets sets;
    if (!cutting.cut_by_integers(near, ties)) return false;
    cutting.drop_by_integers(near, ties, sets);
    keep_planes_of_ties(caps, sets);
  }
  if (cutting.lacks_room() && in_states(count, stays, stays).size() >= many_refused) {
    if (!cutting.cut_anew(in_states(count, has_cut, near_vertex))) return false;
    cutting.drop(in_states(count, has_cut, near_vertex));
  }
  kept_ = without_copies(caps, in_states(count, has_cut, near_vertex)).size();
  return true;
}

bool ExposedCaps::keep(Part part, Caps &caps, uint32_t many) {
  if (small_code) return true;
  // If the ball has another one inside, as every ball has where a set is there twice, other balls may have copies, too.
  if (caps.met > caps.count) {
    for (uint32_t k = 0; k < caps.count; ++k) order_[k] = k;
    caps.keep(without_copies(caps, order_.part(0, caps.count)));
  }
  if (caps.count < many) return true;
  if (!find(part, caps)) return false;
  caps.keep(kept());
  return true;
}

}  // namespace hsp
