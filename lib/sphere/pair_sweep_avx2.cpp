#include "sphere/pair_sweep.hpp"

#if HSP_AVX2
#include "sphere/crossing_pairs_avx2.hpp"

namespace hsp {
namespace {

using Bounds = CapPairBounds<float>;
using Caps8 = LaneCaps<Floats>;
using Points8 = LanePoints<Floats>;

// Heights below which caps belong to the first class, and to the second.
constexpr float class_limits[PairSweep::size_classes - 1] = {0.6F, 0.8F};

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
  uint32_t end = 0;
  for (uint32_t c = 0; c < PairSweep::size_classes; ++c) {
    for (uint32_t k = 0; k < sweep.count; k += 8) {
      const Caps8 caps = Caps8::load(pointers(sweep.caps), k);
      LaneBits members = first_lanes(sweep.count - k);
      if (c > 0) members &= ~greater(Floats::all(class_limits[c - 1]), caps.b);
      if (c + 1 < PairSweep::size_classes) members &= greater(Floats::all(class_limits[c]), caps.b);
      store_chosen(sweep.by_size, end, caps, FrontOrder::of_eight(members));
      end += ones(members);
    }
    sweep.class_end[c] = end;
  }
}

// The lanes whose circles certainly lie inside a cap of the first class. With d = u_k.(b_j u_j) - b_k the depth of its
// centre and S = 1 - g^2, circle j lies inside cap k iff d > 0 and d^2 > S (1 - b_j^2), as
// q = S (1 - b_j^2) - d^2. Where d < 1.2 its square has an error of 2.4 * 73 e and the other side one of 91 e, below
// 512 e together; where d is larger, d^2 - S (1 - b_j^2) > 0.4.
LaneBits inside_large_cap(const PairSweep &sweep, const Caps8 &later) {
  const Floats one = Floats::all(1.0F);
  const Floats square = minus_fused(later.b, later.b, one);
  const Floats margin = Floats::all(Bounds::crossing);
  Floats most = Floats::all(-1.0F);
  for (uint32_t t = 0; t < sweep.class_end[0]; ++t) {
    const Caps8 large = Caps8::all_of(pointers(sweep.by_size), t);
    const Floats g = later.dot(large);
    const Floats depth = fused_minus(g, later.b, large.b);
    const Floats S = minus_fused(g, g, one);
    most = larger(most, minus_fused(S, square, depth * magnitude(depth)));
  }
  return greater(most, margin);
}

void keep_exposed(PairSweep &sweep) {
  uint32_t kept = 0;
  for (uint32_t j = sweep.first_later; j < sweep.count; j += 8) {
    const Caps8 later = Caps8::load(pointers(sweep.caps), j);
    const LaneBits chosen = first_lanes(sweep.count - j) & ~inside_large_cap(sweep, later);
    const FrontOrder order = FrontOrder::of_eight(chosen);
    store_chosen(sweep.exposed, kept, later, order);
    store_front(sweep.exposed_cap + kept, Floats::ascending() + Floats::all(static_cast<float>(j)), order);
    kept += ones(chosen);
  }
  // What follows the last one crosses nothing.
  const Floats zero = Floats::all(0.0F);
  zero.store(sweep.exposed.x + kept);
  zero.store(sweep.exposed.y + kept);
  zero.store(sweep.exposed.z + kept);
  Floats::all(4.0F).store(sweep.exposed.b + kept);
  sweep.exposed_count = kept;
  for (uint32_t a = 0; a < kept; a += 8) sweep.crossed[a / 8] = 0;
}

// Crossing points that no cap has been found to cover so far.
struct alignas(32) OpenPoints {
  static constexpr uint32_t size = 2 * PairSweep::batch + 16;
  float x[size], y[size], z[size], error[size];
  float pair[size];  // its number in the batch, and that plus `batch` for p+
  uint32_t count = 0;

  void keep(const Points8 &points, Floats pairs, LaneBits chosen) {
    const FrontOrder order = FrontOrder::of_eight(chosen);
    store_front(x + count, points.x, order);
    store_front(y + count, points.y, order);
    store_front(z + count, points.z, order);
    store_front(error + count, points.error, order);
    store_front(pair + count, pairs, order);
    count += ones(chosen);
  }
  Points8 at(uint32_t p) const {
    return {Floats::load(x + p), Floats::load(y + p), Floats::load(z + p), Floats::load(error + p)};
  }
};

// Which lanes of two vectors of points certainly lie inside one of the caps first .. last - 1 of by_size.
struct Covered {
  LaneBits first, second;

  Covered(const PairSweep &sweep, const Points8 &a, const Points8 &b, uint32_t begin, uint32_t end) {
    Floats deepest_a = Floats::all(-4.0F), deepest_b = deepest_a;
    for (uint32_t t = begin; t < end; ++t) {
      const Caps8 cap = Caps8::all_of(pointers(sweep.by_size), t);
      deepest_a = larger(deepest_a, a.depth(cap));
      deepest_b = larger(deepest_b, b.depth(cap));
    }
    first = greater(deepest_a, a.error);
    second = greater(deepest_b, b.error);
  }
};

using Pairs = CrossingPairs<Floats, PairSweep::batch>;

// The points of the pairs that are in no large cap.
void open_points(const PairSweep &sweep, const Pairs &pairs, OpenPoints &open) {
  for (uint32_t p = 0; p < pairs.count; p += 8) {
    LaneCrossings<Floats> crossings(pairs, p);
    // Of circles that do not cross for certain no point is certainly covered.
    const LaneBits valid = first_lanes(pairs.count - p);
    const LaneBits sure = greater(Floats::load(pairs.q + p), Floats::all(Bounds::points));
    const Covered covered(sweep, crossings.minus, crossings.plus, 0, sweep.class_end[0]);
    const Floats number = Floats::ascending() + Floats::all(static_cast<float>(p));
    open.keep(crossings.minus, number, valid & ~(sure & covered.first));
    open.keep(crossings.plus, number + Floats::all(static_cast<float>(PairSweep::batch)),
              valid & ~(sure & covered.second));
  }
}

void leave_out_covered(const PairSweep &sweep, uint32_t begin, uint32_t end, OpenPoints &open) {
  const uint32_t count = open.count;
  open.count = 0;
  for (uint32_t p = 0; p < count; p += 16) {
    const Points8 a = open.at(p), b = open.at(p + 8);
    const Floats pairs_a = Floats::load(open.pair + p), pairs_b = Floats::load(open.pair + p + 8);
    const Covered covered(sweep, a, b, begin, end);
    open.keep(a, pairs_a, first_lanes(count - p) & ~covered.first);
    if (count - p > 8) open.keep(b, pairs_b, first_lanes(count - p - 8) & ~covered.second);
  }
}

// Whether a point is certainly outside all caps but its own two, on which it lies.
bool is_free(const PairSweep &sweep, const OpenPoints &open, uint32_t p) {
  const Points8 point{Floats::all_of(open.x + p), Floats::all_of(open.y + p), Floats::all_of(open.z + p),
                      Floats::all_of(open.error + p)};
  uint32_t near = 0;
  for (uint32_t t = 0; t < sweep.count; t += 8) {
    const Caps8 caps = Caps8::load(pointers(sweep.caps), t);
    near += ones(not_less(point.depth(caps), -point.error) & first_lanes(sweep.count - t));
  }
  return near == 2;
}

uint32_t cap_number(const PairSweep &sweep, uint32_t exposed) {
  return static_cast<uint32_t>(sweep.exposed_cap[exposed]);
}

// What is left of a batch.
uint32_t answer(PairSweep &sweep, const Pairs &pairs, OpenPair *answers) {
  OpenPoints open;
  open_points(sweep, pairs, open);
  for (uint32_t c = 1; c < PairSweep::size_classes; ++c) {
    leave_out_covered(sweep, sweep.class_end[c - 1], sweep.class_end[c], open);
  }
  uint64_t any = 0, doubtful = 0, minus = 0, plus = 0;
  for (uint32_t p = 0; p < open.count; ++p) {
    const uint32_t number = static_cast<uint32_t>(open.pair[p]);
    const uint64_t bit = UINT64_C(1) << number % PairSweep::batch;
    any |= bit;
    if (!(pairs.q[number % PairSweep::batch] > Bounds::points) || !is_free(sweep, open, p)) doubtful |= bit;
    (number < PairSweep::batch ? minus : plus) |= bit;
  }
  uint32_t found = 0;
  for (; any != 0; any &= any - 1) {
    const uint32_t p = static_cast<uint32_t>(__builtin_ctzll(any));
    answers[found++] = {cap_number(sweep, static_cast<uint32_t>(pairs.j[p])),
                        cap_number(sweep, static_cast<uint32_t>(pairs.k[p])), (doubtful >> p & 1U) == 0,
                        (minus >> p & 1U) != 0, (plus >> p & 1U) != 0};
  }
  sweep.crossing += pairs.count;
  return found;
}

// Adds pairs of the row from its column on until there are enough; circles that cross are marked. Returns whether the
// row is done.
bool add_pairs_of_row(PairSweep &sweep, Pairs &pairs) {
  const uint32_t row = sweep.row;
  const Caps8 cap = Caps8::all_of(pointers(sweep.exposed), row);
  LaneBits crossed = 0;
  uint32_t c = sweep.column;
  for (; c < sweep.exposed_count && !pairs.is_full(); c += 8) {
    const Caps8 others = Caps8::load(pointers(sweep.exposed), c);
    const PairLanes<Floats> pair(cap, others);
    const LaneBits valid = first_lanes(sweep.exposed_count - c) & (c > row ? 255U : 254U << (row - c));
    const LaneBits crossing = valid & greater(pair.q, Floats::all(Bounds::crossing));
    pairs.add(row, cap, c, others, pair, valid & ~greater(Floats::all(-Bounds::crossing), pair.q));
    sweep.crossed[c / 8] = static_cast<uint8_t>(sweep.crossed[c / 8] | crossing);
    crossed |= crossing;
  }
  if (crossed != 0) sweep.crossed[row / 8] = static_cast<uint8_t>(sweep.crossed[row / 8] | 1U << row % 8);
  sweep.column = c;
  return c >= sweep.exposed_count;
}

}  // namespace

void start_sweep(PairSweep &sweep) {
  sort_by_size(sweep);
  keep_exposed(sweep);
  sweep.row = 0;
  sweep.column = 0;
  sweep.crossing = 0;
}

uint32_t next_open_pairs(PairSweep &sweep, OpenPair *answers) {
  while (sweep.row + 1 < sweep.exposed_count) {
    Pairs pairs;
    while (sweep.row + 1 < sweep.exposed_count && !pairs.is_full()) {
      if (!add_pairs_of_row(sweep, pairs)) continue;
      ++sweep.row;
      sweep.column = (sweep.row + 1) & ~7U;
    }
    const uint32_t found = answer(sweep, pairs, answers);
    if (found > 0) return found;
  }
  return 0;
}

uint32_t uncrossed_caps(const PairSweep &sweep, uint32_t *caps) {
  uint32_t found = 0;
  for (uint32_t a = 0; a < sweep.exposed_count; ++a) {
    if ((sweep.crossed[a / 8] >> a % 8 & 1U) == 0) caps[found++] = cap_number(sweep, a);
  }
  return found;
}

}  // namespace hsp
#endif
