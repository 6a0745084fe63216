#include "sphere/pair_sweep.hpp"

#if HSP_AVX2
#include "sphere/covered_circles_avx2.hpp"
#include "sphere/crossing_pairs_avx2.hpp"

namespace hsp {
namespace {

using Bounds = CapPairBounds<float>;
using Caps8 = LaneCaps<Floats>;
using Points8 = LanePoints<Floats>;

// Heights below which caps belong to the first class, to the second and to the third.
constexpr float class_limits[PairSweep::size_classes] = {0.5F, 0.7F, 0.85F};
// Those of the first two are called large.
constexpr uint32_t last_large_class = 1;
constexpr uint32_t last_class = PairSweep::size_classes - 1;

CapPointers<float> pointers(const FloatCaps &caps) {
  return {caps.x, caps.y, caps.z, caps.b};
}

void store_chosen(const FloatCaps &to, uint32_t place, const Caps8 &caps, FrontOrder order) {
  store_front(to.x + place, caps.x, order);
  store_front(to.y + place, caps.y, order);
  store_front(to.z + place, caps.z, order);
  store_front(to.b + place, caps.b, order);
}

void sort_by_size(PairSweep &sweep) {
  const CapPointers<float> from = pointers(sweep.caps);
  const FloatCaps to = sweep.by_size;
  const uint32_t count = sweep.count;
  Floats least = Floats::all(-4.0F);
  uint32_t end = 0;
  for (uint32_t c = 0; c < PairSweep::size_classes; ++c) {
    const Floats limit = Floats::all(class_limits[c]);
    // What stands behind the last cap is of no class.
    for (uint32_t k = 0; k < count; k += 8) {
      const Caps8 caps = Caps8::load(from, k);
      const LaneBits members = greater(limit, caps.b) & not_greater(least, caps.b);
      store_chosen(to, end, caps, FrontOrder::of_eight(members));
      end += ones(members);
    }
    sweep.class_end[c] = end;
    least = limit;
  }
}

// How some circles lie to the large caps. With d = u_k.(b_j u_j) - b_k the depth of the centre of circle j in cap k and
// S = 1 - g^2, the circles cross iff q = S (1 - b_j^2) - d^2 > 0, and circle j lies inside cap k iff q < 0 and d > 0.
// Where |d| < 1.2 its square has an error of 2.4 * 73 e and the other product one of 91 e, below 512 e together; where
// it is larger, -q > 0.4. If -q > 512 e, |d| is above 512 e too.
struct AmongLargeCaps {
  Floats inside = Floats::all(-4.0F);    // the circle lies inside one if this is above the bound
  Floats crossing = Floats::all(-4.0F);  // and it crosses one if this is

  AmongLargeCaps(const CapPointers<float> &large, uint32_t count, const Caps8 &later) {
    const Floats one = Floats::all(1.0F);
    const Floats square = minus_fused(later.b, later.b, one);
    Floats least = Floats::all(4.0F);
    for (uint32_t t = 0; t < count; ++t) {
      const Caps8 cap = Caps8::all_of(large, t);
      const Floats g = later.dot(cap);
      const Floats depth = fused_minus(g, later.b, cap.b);
      const Floats S = minus_fused(g, g, one);
      const Floats minus_q = minus_fused(S, square, depth * depth);
      inside = larger(inside, smaller(depth, minus_q));
      least = smaller(least, minus_q);
    }
    crossing = -least;
  }
};

// What follows the last exposed circle crosses nothing.
void end_exposed(PairSweep &sweep, uint32_t count) {
  const Floats zero = Floats::all(0.0F);
  zero.store(sweep.exposed.x + count);
  zero.store(sweep.exposed.y + count);
  zero.store(sweep.exposed.z + count);
  Floats::all(4.0F).store(sweep.exposed.b + count);
  zero.store(sweep.crossed + count);
  sweep.exposed_count = count;
}

void keep_exposed(PairSweep &sweep) {
  const CapPointers<float> caps = pointers(sweep.caps), large = pointers(sweep.by_size);
  const FloatCaps exposed = sweep.exposed;
  float *const exposed_cap = sweep.exposed_cap, *const crossed = sweep.crossed;
  const uint32_t count = sweep.count, large_caps = sweep.class_end[last_large_class];
  const Floats margin = Floats::all(Bounds::crossing);
  uint32_t kept = 0;
  for (uint32_t j = sweep.first_later; j < count; j += 8) {
    const Caps8 later = Caps8::load(caps, j);
    const AmongLargeCaps among(large, large_caps, later);
    const LaneBits chosen = first_lanes(count - j) & not_greater(among.inside, margin);
    const FrontOrder order = FrontOrder::of_eight(chosen);
    store_chosen(exposed, kept, later, order);
    store_front(exposed_cap + kept, Floats::ascending() + Floats::all(static_cast<float>(j)), order);
    store_front(crossed + kept, among.crossing, order);
    kept += ones(chosen);
  }
  end_exposed(sweep, kept);
}

// Leaves out circles that large caps certainly cover together. The pairs of a few circles are looked at sooner.
void leave_out_covered_circles(PairSweep &sweep) {
  const CapPointers<float> from = pointers(sweep.exposed), large = pointers(sweep.by_size);
  const uint32_t count = sweep.exposed_count, large_caps = sweep.class_end[last_large_class];
  if (count <= 8) return;
  uint32_t kept = 0;
  for (uint32_t a = 0; a < count; a += 8) {
    const Caps8 circles = Caps8::load(from, a);
    CoveredArcs arcs(circles);
    for (uint32_t t = 0; t < large_caps; ++t) arcs.cover(Caps8::all_of(large, t));
    const Floats caps = Floats::load(sweep.exposed_cap + a), crossed = Floats::load(sweep.crossed + a);
    const LaneBits chosen = first_lanes(count - a) & ~arcs.covered();
    const FrontOrder order = FrontOrder::of_eight(chosen);
    store_chosen(sweep.exposed, kept, circles, order);
    store_front(sweep.exposed_cap + kept, caps, order);
    store_front(sweep.crossed + kept, crossed, order);
    kept += ones(chosen);
  }
  end_exposed(sweep, kept);
}

// Crossing points that no cap has been found to cover so far. Their count is kept apart, as that of CrossingPairs is.
struct alignas(32) OpenPoints {
  static constexpr uint32_t size = 2 * PairSweep::batch + 16;
  float x[size], y[size], z[size], error[size];
  float pair[size];  // its number in the batch, and that plus `batch` for p+

  // Puts the chosen ones behind `count` others. Returns how many there are then.
  uint32_t keep(uint32_t count, const Points8 &points, Floats pairs, LaneBits chosen) {
    const FrontOrder order = FrontOrder::of_eight(chosen);
    store_front(x + count, points.x, order);
    store_front(y + count, points.y, order);
    store_front(z + count, points.z, order);
    store_front(error + count, points.error, order);
    store_front(pair + count, pairs, order);
    return count + ones(chosen);
  }
  Points8 at(uint32_t p) const {
    return {Floats::load(x + p), Floats::load(y + p), Floats::load(z + p), Floats::load(error + p)};
  }
  Points8 in_all_lanes(uint32_t p) const {
    return {Floats::all_of(x + p), Floats::all_of(y + p), Floats::all_of(z + p), Floats::all_of(error + p)};
  }
};

// Which lanes of two vectors of points do not certainly lie inside one of caps begin .. end - 1.
struct NotCovered {
  LaneBits first, second;

  NotCovered(const CapPointers<float> &caps, uint32_t begin, uint32_t end, const Points8 &a, const Points8 &b) {
    Floats deepest_a = Floats::all(-4.0F), deepest_b = deepest_a;
    for (uint32_t t = begin; t < end; ++t) {
      const Caps8 cap = Caps8::all_of(caps, t);
      deepest_a = larger(deepest_a, a.depth(cap));
      deepest_b = larger(deepest_b, b.depth(cap));
    }
    first = not_greater(deepest_a, a.error);
    second = not_greater(deepest_b, b.error);
  }
};

using Pairs = CrossingPairs<Floats, PairSweep::batch>;

// The points of `count` pairs that are in no cap of the first class. Returns how many they are.
uint32_t open_points(const CapPointers<float> &by_size, uint32_t first_class, const Pairs &pairs, uint32_t count,
                     OpenPoints &open) {
  const Floats points_bound = Floats::all(Bounds::points), infinite = Floats::all(__builtin_inff());
  uint32_t left = 0;
  for (uint32_t p = 0; p < count; p += 8) {
    LaneCrossings<Floats> crossings(pairs, p);
    // Of circles that do not cross for certain no point is certainly covered.
    const Floats error = where_greater(Floats::load(pairs.q + p), points_bound, crossings.plus.error, infinite);
    crossings.minus.error = crossings.plus.error = error;
    const LaneBits valid = first_lanes(count - p);
    const NotCovered open_lanes(by_size, 0, first_class, crossings.minus, crossings.plus);
    const Floats number = Floats::ascending() + Floats::all(static_cast<float>(p));
    left = open.keep(left, crossings.minus, number, valid & open_lanes.first);
    left = open.keep(left, crossings.plus, number + Floats::all(static_cast<float>(PairSweep::batch)),
                     valid & open_lanes.second);
  }
  return left;
}

constexpr uint32_t passed_at_once = 16;

// Leaves out points that are in one of caps begin .. end - 1. Returns how many are left of `count`.
uint32_t leave_out_covered(const CapPointers<float> &by_size, uint32_t begin, uint32_t end, OpenPoints &open,
                           uint32_t count) {
  uint32_t left = 0;
  for (uint32_t p = 0; p < count; p += passed_at_once) {
    const Points8 a = open.at(p), b = open.at(p + 8);
    const Floats pairs_a = Floats::load(open.pair + p), pairs_b = Floats::load(open.pair + p + 8);
    const NotCovered open_lanes(by_size, begin, end, a, b);
    left = open.keep(left, a, pairs_a, first_lanes(count - p) & open_lanes.first);
    // Without a branch on how many there are.
    left = open.keep(left, b, pairs_b, first_lanes(count - p > 8 ? count - p - 8 : 0) & open_lanes.second);
  }
  return left;
}

// A point is open if it is not certainly covered. It is certainly free outside all caps but its own two, on which it
// lies.
struct PointAnswer {
  bool open, certain;
};

PointAnswer among_all_caps(const CapPointers<float> &caps, uint32_t count, const OpenPoints &open, uint32_t p) {
  const Points8 point = open.in_all_lanes(p);
  const Floats below = -point.error;
  Floats deepest = Floats::all(-4.0F);
  uint32_t near = 0;
  // What stands behind the last cap is far from the point, unless nothing is certain of it.
  for (uint32_t t = 0; t < count; t += 8) {
    const Floats depth = point.depth(Caps8::load(caps, t));
    deepest = larger(deepest, depth);
    near += ones(not_less(depth, below));
  }
  return {greater(deepest, point.error) == 0, near == 2};
}

uint32_t cap_number(const PairSweep &sweep, float exposed) {
  return static_cast<uint32_t>(sweep.exposed_cap[static_cast<uint32_t>(exposed)]);
}

// What is left of a batch.
uint32_t answer(const PairSweep &sweep, const Pairs &pairs, uint32_t count, OpenPair *answers) {
  OpenPoints open;
  const CapPointers<float> by_size = pointers(sweep.by_size);
  uint32_t points = open_points(by_size, sweep.class_end[0], pairs, count, open);
  // Class by class as long as that saves a pass.
  for (uint32_t c = 0, next = 0; c < last_class; c = next) {
    next = points > passed_at_once ? c + 1 : last_class;
    points = leave_out_covered(by_size, sweep.class_end[c], sweep.class_end[next], open, points);
  }
  const CapPointers<float> caps = pointers(sweep.caps);
  uint64_t doubtful = 0, minus = 0, plus = 0;
  for (uint32_t p = 0; p < points; ++p) {
    // No branch depends on the answer, which cannot be predicted.
    const PointAnswer state = among_all_caps(caps, sweep.count, open, p);
    const uint32_t number = static_cast<uint32_t>(open.pair[p]);
    const uint64_t bit = static_cast<uint64_t>(state.open) << number % PairSweep::batch;
    doubtful |= state.certain ? 0 : bit;
    minus |= number < PairSweep::batch ? bit : 0;
    plus |= number < PairSweep::batch ? 0 : bit;
  }
  uint32_t found = 0;
  for (uint64_t any = minus | plus; any != 0; any &= any - 1) {
    const uint32_t p = static_cast<uint32_t>(__builtin_ctzll(any));
    answers[found++] = {cap_number(sweep, pairs.j[p]), cap_number(sweep, pairs.k[p]), (doubtful >> p & 1U) == 0,
                        (minus >> p & 1U) != 0, (plus >> p & 1U) != 0};
  }
  return found;
}

// Adds pairs from the sweep's row and column on until there are enough of them. Returns how many pairs there are.
uint32_t add_pairs(PairSweep &sweep, Pairs &pairs) {
  const CapPointers<float> exposed = pointers(sweep.exposed);
  const uint32_t exposed_count = sweep.exposed_count;
  const Floats apart = Floats::all(-Bounds::crossing);
  uint32_t row = sweep.row, column = sweep.column, count = 0;
  while (row + 1 < exposed_count && !Pairs::is_full(count)) {
    const Caps8 cap = Caps8::all_of(exposed, row);
    const Floats row_number = Floats::all(static_cast<float>(row));
    Floats numbers = Floats::ascending() + Floats::all(static_cast<float>(column));
    for (; column < exposed_count && !Pairs::is_full(count); column += 8) {
      const Caps8 others = Caps8::load(exposed, column);
      const PairLanes<Floats> pair(cap, others);
      count = pairs.add(count, row_number, cap, numbers, others, pair, not_greater(apart, pair.q));
      numbers = numbers + Floats::all(8.0F);
    }
    if (column >= exposed_count) column = ++row + 1;
  }
  sweep.row = row;
  sweep.column = column;
  sweep.crossing += count;
  return count;
}

// Whether a circle certainly crosses another one, or lies inside a cap as a whole: by the formulas of AmongLargeCaps,
// the circle being one and the caps all, itself among them, of which nothing is certain.
bool has_covered_point(const CapPointers<float> &caps, uint32_t count, uint32_t circle) {
  const Caps8 own = Caps8::all_of(caps, circle);
  const Floats one = Floats::all(1.0F), margin = Floats::all(Bounds::crossing);
  const Floats square = minus_fused(own.b, own.b, one);
  Floats covered = Floats::all(-4.0F);
  for (uint32_t t = 0; t < count; t += 8) {
    const Caps8 cap = Caps8::load(caps, t);
    const Floats g = own.dot(cap);
    const Floats depth = fused_minus(g, own.b, cap.b);
    const Floats minus_q = minus_fused(minus_fused(g, g, one), square, depth * depth);
    covered = larger(covered, larger(smaller(depth, minus_q), -minus_q));
  }
  return greater(covered, margin) != 0;
}

}  // namespace

void start_sweep(PairSweep &sweep) {
  sort_by_size(sweep);
  keep_exposed(sweep);
  leave_out_covered_circles(sweep);
  sweep.row = 0;
  sweep.column = 1;
  sweep.crossing = 0;
}

uint32_t next_open_pairs(PairSweep &sweep, OpenPair *answers) {
  Pairs pairs;
  while (sweep.row + 1 < sweep.exposed_count) {
    const uint32_t count = add_pairs(sweep, pairs);
    const uint32_t found = answer(sweep, pairs, count, answers);
    if (found > 0) return found;
  }
  return 0;
}

uint32_t uncrossed_caps(const PairSweep &sweep, uint32_t *caps) {
  const Floats margin = Floats::all(Bounds::crossing);
  uint32_t found = 0;
  for (uint32_t a = 0; a < sweep.exposed_count; a += 8) {
    LaneBits left = first_lanes(sweep.exposed_count - a) & not_greater(Floats::load(sweep.crossed + a), margin);
    for (; left != 0; left &= left - 1) {
      const uint32_t cap = static_cast<uint32_t>(sweep.exposed_cap[a + lowest(left)]);
      caps[found] = cap;
      found += static_cast<uint32_t>(!has_covered_point(pointers(sweep.caps), sweep.count, cap));
    }
  }
  return found;
}

}  // namespace hsp
#endif
