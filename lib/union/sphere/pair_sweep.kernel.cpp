#include "sphere/pair_sweep.hpp"
#include "sphere/covered_circles.hpp"

namespace hsp::HSP_TARGET {
namespace {

using Bounds = CapPairBounds<float>;
using SomeCaps = LaneCaps<Floats>;
using SomePoints = LanePoints<Floats>;

// Heights below which caps belong to the first class and to the second. Those of either are called large.
constexpr float class_limits[PairSweep::size_classes] = {0.5F, 0.75F};
constexpr uint32_t last_class = PairSweep::size_classes - 1;

CapPointers<float> pointers(const FloatCaps &caps) {
  return {caps.x, caps.y, caps.z, caps.b};
}

void store_chosen(const FloatCaps &to, uint32_t place, const SomeCaps &caps, const FrontOrder &order) {
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
    // Lanes after the last cap belong to no class.
    for (uint32_t k = 0; k < count; k += Floats::lanes) {
      const SomeCaps caps = SomeCaps::load(from, k);
      const LaneBits members = greater(limit, caps.b) & not_greater(least, caps.b);
      store_chosen(to, end, caps, FrontOrder::of(members));
      end += ones(members);
    }
    sweep.class_end[c] = end;
    least = limit;
  }
}

void store_large(PairSweep &sweep) {
  const CapPointers<float> from = pointers(sweep.by_size);
  const FloatCaps to = sweep.large;
  const uint32_t count = sweep.class_end[last_class];
  for (uint32_t k = 0; k < count; k += Floats::lanes) {
    store_as_fractions(SomeCaps::load(from, k), to.x + k, to.y + k, to.z + k, to.b + k);
  }
}

// How circles, as many as there are fractions, lie to the large caps. With d = u_k.(b_j u_j) - b_k the depth of the
// centre of circle j in cap k and S = 1 - g^2, the circles cross iff q = S (1 - b_j^2) - d^2 > 0, and circle j lies
// inside cap k iff q < 0 and d > 0. With f = 2^-15 and by covered_circles.hpp, d is known to 7.5 f and its square to
// 15.5; g^2 to 10.5, S to 11, 1 - b_j^2 to 1.1 and their product to 12.6: q to 28.1 f, below the margin of 32 f. Where
// d > 1 it stops there, and its square at 1, which S (1 - b_j^2) does not exceed. Where d < -0.99 it is taken for that:
// as b_k < 7/8, |b_j g| > 0.11 then, and S (1 - b_j^2) <= (1 - |b_j g|)^2 < 0.8, so that the circles still seem to be
// apart.
class AmongLargeCaps {
 public:
  AmongLargeCaps(const CapPointers<float> &large, uint32_t count, const SomeCaps &low, const SomeCaps &high) {
    const FractionCircles circles(low, high);
    const Floats one = Floats::all(1.0F);
    const Fractions square = Fractions::of(minus_fused(low.b, low.b, one), minus_fused(high.b, high.b, one), 1.0F);
#pragma GCC unroll 2
    for (uint32_t t = 0; t < count; ++t) {
      const FractionCap cap = FractionCap::all_of(large, t);
      const Fractions g = cap.dot(circles.u);
      const Fractions depth = larger(g * circles.b - cap.b, Fractions::all(-0.99F));
      const Fractions S = Fractions::all(fraction_factor * fraction_factor) - g * g;
      const Fractions minus_q = depth * depth - S * square;
      inside_ = larger(inside_, smaller(depth, minus_q));
      least_ = smaller(least_, minus_q);
    }
    outside_ = inside_ - margin();
    crossing_ = least_ + margin();
  }
  // The circles that do not certainly lie inside one.
  LaneBits low_outside() const {
    return negative(outside_.signs_of_low());
  }
  LaneBits high_outside() const {
    return negative(outside_.signs_of_high());
  }
  // Negative for circles that certainly cross that of one.
  Floats low_crossing() const {
    return crossing_.signs_of_low();
  }
  Floats high_crossing() const {
    return crossing_.signs_of_high();
  }

 private:
  static Fractions margin() {
    return Fractions::all(0x1p-10F);
  }

  Fractions inside_ = Fractions::all(-1.0F), least_ = Fractions::all(1.0F - 0x1p-15F);
  Fractions outside_, crossing_;
};

// Circles after the last exposed one cross nothing.
void end_exposed(PairSweep &sweep, uint32_t count) {
  const Floats zero = Floats::all(0.0F);
  zero.store(sweep.exposed.x + count);
  zero.store(sweep.exposed.y + count);
  zero.store(sweep.exposed.z + count);
  Floats::all(4.0F).store(sweep.exposed.b + count);
  zero.store(sweep.crossed + count);
  sweep.exposed_count = count;
}

// The arrays of exposed circles, to which circles are added. They may come from the same arrays, from behind there.
class ExposedCircles {
 public:
  explicit ExposedCircles(PairSweep &sweep) : to_(sweep.exposed), cap_(sweep.exposed_cap), crossed_(sweep.crossed) {}

  void keep(const SomeCaps &circles, Floats caps, Floats crossed, LaneBits chosen) {
    const FrontOrder order = FrontOrder::of(chosen);
    store_chosen(to_, kept_, circles, order);
    store_front(cap_ + kept_, caps, order);
    store_front(crossed_ + kept_, crossed, order);
    kept_ += ones(chosen);
  }
  uint32_t kept() const { return kept_; }

 private:
  FloatCaps to_;
  float *cap_, *crossed_;
  uint32_t kept_ = 0;
};

void keep_exposed(PairSweep &sweep) {
  const CapPointers<float> caps = pointers(sweep.caps), large = pointers(sweep.large);
  const uint32_t count = sweep.count, large_caps = sweep.class_end[last_class];
  ExposedCircles exposed(sweep);
  for (uint32_t j = sweep.first_later; j < count; j += 2 * Floats::lanes) {
    // Lanes after the last circle are left out below.
    const SomeCaps low = SomeCaps::load(caps, j), high = SomeCaps::load(caps, j + Floats::lanes);
    const AmongLargeCaps among(large, large_caps, low, high);
    const Floats number = Floats::ascending() + Floats::all(static_cast<float>(j));
    exposed.keep(low, number, among.low_crossing(), first_lanes(count - j) & among.low_outside());
    if (j + Floats::lanes >= count) break;
    exposed.keep(high, number + Floats::all(static_cast<float>(Floats::lanes)), among.high_crossing(),
                 first_lanes(count - j - Floats::lanes) & among.high_outside());
  }
  end_exposed(sweep, exposed.kept());
}

// Leaves out circles that large caps certainly cover together. The pairs of a few circles are looked at sooner.
void leave_out_covered_circles(PairSweep &sweep) {
  const CapPointers<float> from = pointers(sweep.exposed), large = pointers(sweep.large);
  const uint32_t count = sweep.exposed_count, large_caps = sweep.class_end[last_class];
  if (count <= 8) return;
  ExposedCircles exposed(sweep);
  const auto keep = [&](uint32_t a, const SomeCaps &circles, LaneBits chosen) {
    exposed.keep(circles, Floats::load(sweep.exposed_cap + a), Floats::load(sweep.crossed + a), chosen);
  };
  for (uint32_t a = 0; a < count; a += 2 * Floats::lanes) {
    const SomeCaps low = SomeCaps::load(from, a), high = SomeCaps::load(from, a + Floats::lanes);
    CoveredArcs arcs(low, high);
    for (uint32_t t = 0; t < large_caps; ++t) arcs.cover(FractionCap::all_of(large, t));
    const CoveredArcs::Covered covered = arcs.covered();
    keep(a, low, first_lanes(count - a) & ~covered.low);
    if (a + Floats::lanes < count)
      keep(a + Floats::lanes, high, first_lanes(count - a - Floats::lanes) & ~covered.high);
  }
  end_exposed(sweep, exposed.kept());
}

// Crossing points that no cap has been found to cover so far. Their count is kept apart, as that of CrossingPairs is.
struct alignas(32) OpenPoints {
  static constexpr uint32_t size = 2 * PairSweep::batch + 16;
  float x[size], y[size], z[size], error[size];
  float pair[size];  // its number in the batch, and that plus `batch` for p+

  // Puts the chosen ones behind `count` others. Returns how many there are then.
  uint32_t keep(uint32_t count, const SomePoints &points, Floats pairs, LaneBits chosen) {
    const FrontOrder order = FrontOrder::of(chosen);
    store_front(x + count, points.x, order);
    store_front(y + count, points.y, order);
    store_front(z + count, points.z, order);
    store_front(error + count, points.error, order);
    store_front(pair + count, pairs, order);
    return count + ones(chosen);
  }
  SomePoints at(uint32_t p) const {
    return {Floats::load(x + p), Floats::load(y + p), Floats::load(z + p), Floats::load(error + p)};
  }
  SomePoints in_all_lanes(uint32_t p) const {
    return {Floats::all_of(x + p), Floats::all_of(y + p), Floats::all_of(z + p), Floats::all_of(error + p)};
  }
};

// Which lanes of two vectors of points do not certainly lie inside one of caps begin .. end - 1.
struct NotCovered {
  LaneBits first, second;

  NotCovered(const CapPointers<float> &caps, uint32_t begin, uint32_t end, const SomePoints &a, const SomePoints &b) {
    Floats deepest_a = Floats::all(-4.0F), deepest_b = deepest_a;
#pragma GCC unroll 2
    for (uint32_t t = begin; t < end; ++t) {
      const SomeCaps cap = SomeCaps::all_of(caps, t);
      deepest_a = larger(deepest_a, a.depth(cap));
      deepest_b = larger(deepest_b, b.depth(cap));
    }
    first = not_greater(deepest_a, a.error);
    second = not_greater(deepest_b, b.error);
  }
};

// Adds those points of pairs, number p, p + 1, ..., that are in no cap of the first class. Returns how many
// points there are then.
[[gnu::always_inline]] inline uint32_t add_points(const CapPointers<float> &by_size, uint32_t first_class,
                                                  LaneCrossings<Floats> crossings, Floats q, uint32_t p, LaneBits valid,
                                                  OpenPoints &open, uint32_t count) {
  // Of circles that do not cross for certain no point is certainly covered.
  const Floats error =
      where_greater(q, Floats::all(Bounds::points), crossings.plus.error, Floats::all(__builtin_inff()));
  crossings.minus.error = crossings.plus.error = error;
  const NotCovered open_lanes(by_size, 0, first_class, crossings.minus, crossings.plus);
  const Floats number = Floats::ascending() + Floats::all(static_cast<float>(p));
  count = open.keep(count, crossings.minus, number, valid & open_lanes.first);
  return open.keep(count, crossings.plus, number + Floats::all(static_cast<float>(PairSweep::batch)),
                   valid & open_lanes.second);
}

using Pairs = CrossingPairs<Floats, PairSweep::batch>;

// The points of `count` pairs that are in no cap of the first class. Returns how many they are.
uint32_t open_points(const CapPointers<float> &by_size, uint32_t first_class, const Pairs &pairs, uint32_t count,
                     OpenPoints &open) {
  uint32_t left = 0;
  for (uint32_t p = 0; p < count; p += Floats::lanes) {
    left = add_points(by_size, first_class, LaneCrossings<Floats>(pairs, p), Floats::load(pairs.q + p), p,
                      first_lanes(count - p), open, left);
  }
  return left;
}

// All pairs j < k of up to eight things, in order.
struct PairsOfFew {
  static constexpr uint32_t most = 8, size = 32;
  alignas(64) uint8_t j[most + 1][size];
  uint8_t k[most + 1][size];

  static constexpr uint32_t count(uint32_t things) { return things * (things - 1) / 2; }
  constexpr PairsOfFew() : j{}, k{} {
    for (uint32_t things = 2; things <= most; ++things) {
      uint32_t p = 0;
      for (uint8_t a = 0; a < things; ++a) {
        for (uint8_t b = static_cast<uint8_t>(a + 1); b < things; ++b, ++p) {
          j[things][p] = a;
          k[things][p] = b;
        }
      }
    }
  }
};
constexpr PairsOfFew pairs_of_few;

// The same of all pairs of the few exposed circles, without a branch on which of them cross.
uint32_t open_points_of_few(PairSweep &sweep, OpenPoints &open) {
  const CapPointers<float> by_size = pointers(sweep.by_size);
  const uint32_t circles = sweep.exposed_count, count = PairsOfFew::count(circles);
  const EightFloats x = EightFloats::load(sweep.exposed.x), y = EightFloats::load(sweep.exposed.y),
                    z = EightFloats::load(sweep.exposed.z), b = EightFloats::load(sweep.exposed.b);
  const auto caps_in_order = [&](const uint8_t *order) {
    return SomeCaps{x.in_order(order), y.in_order(order), z.in_order(order), b.in_order(order)};
  };
  uint32_t left = 0;
  for (uint32_t p = 0; p < count; p += Floats::lanes) {
    const SomeCaps u = caps_in_order(pairs_of_few.j[circles] + p), v = caps_in_order(pairs_of_few.k[circles] + p);
    const PairLanes<Floats> pair(u, v);
    const LaneBits crossing = first_lanes(count - p) & not_greater(Floats::all(-Bounds::crossing), pair.q);
    sweep.crossing += ones(crossing);
    left = add_points(by_size, sweep.class_end[0], {u, v, pair.g, pair.q}, pair.q, p, crossing, open, left);
  }
  return left;
}

constexpr uint32_t passed_at_once = 2 * Floats::lanes;

// Leaves out points that are in one of caps begin .. end - 1. Returns how many are left of `count`.
[[gnu::always_inline]] inline uint32_t leave_out_covered(const CapPointers<float> &by_size, uint32_t begin,
                                                         uint32_t end, OpenPoints &open, uint32_t count) {
  uint32_t left = 0;
  for (uint32_t p = 0; p < count; p += passed_at_once) {
    const SomePoints a = open.at(p), b = open.at(p + Floats::lanes);
    const Floats pairs_a = Floats::load(open.pair + p), pairs_b = Floats::load(open.pair + p + Floats::lanes);
    const NotCovered open_lanes(by_size, begin, end, a, b);
    left = open.keep(left, a, pairs_a, first_lanes(count - p) & open_lanes.first);
    // Without a branch on how many there are.
    left = open.keep(left, b, pairs_b,
                     first_lanes(count - p > Floats::lanes ? count - p - Floats::lanes : 0) & open_lanes.second);
  }
  return left;
}

// A point is open if it is not certainly covered. It is certainly free outside all caps but its own two, on which it
// lies.
struct PointAnswer {
  bool open, certain;
};

[[gnu::always_inline]] inline PointAnswer among_all_caps(const CapPointers<float> &caps, uint32_t count,
                                                         const OpenPoints &open, uint32_t p) {
  const SomePoints point = open.in_all_lanes(p);
  const Floats below = -point.error;
  Floats deepest = Floats::all(-4.0F);
  uint32_t near = 0;
  // Lanes after the last cap are far from the point, unless nothing is certain of it.
  for (uint32_t t = 0; t < count; t += Floats::lanes) {
    const Floats depth = point.depth(SomeCaps::load(caps, t));
    deepest = larger(deepest, depth);
    near += ones(not_less(depth, below));
  }
  return {greater(deepest, point.error) == 0, near == 2};
}

uint32_t cap_number(const PairSweep &sweep, uint32_t exposed) {
  return static_cast<uint32_t>(sweep.exposed_cap[exposed]);
}

struct CirclePair {
  uint32_t j, k;
};

// The rest of a batch, of whose open points so many are known. circles_of(p) are the numbers of the exposed circles
// of pair p.
template <class CirclesOf>
uint32_t answer(const PairSweep &sweep, OpenPoints &open, uint32_t points, CirclesOf circles_of, OpenPair *answers) {
  points = leave_out_covered(pointers(sweep.by_size), sweep.class_end[0], sweep.class_end[last_class], open, points);
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
    const CirclePair pair = circles_of(p);
    answers[found++] = {cap_number(sweep, pair.j), cap_number(sweep, pair.k), (doubtful >> p & 1U) == 0,
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
    const SomeCaps cap = SomeCaps::all_of(exposed, row);
    const Floats row_number = Floats::all(static_cast<float>(row));
    Floats numbers = Floats::ascending() + Floats::all(static_cast<float>(column));
    for (; column < exposed_count && !Pairs::is_full(count); column += Floats::lanes) {
      const SomeCaps others = SomeCaps::load(exposed, column);
      const PairLanes<Floats> pair(cap, others);
      count = pairs.add(count, row_number, cap, numbers, others, pair, not_greater(apart, pair.q));
      numbers = numbers + Floats::all(static_cast<float>(Floats::lanes));
    }
    if (column >= exposed_count) column = ++row + 1;
  }
  sweep.row = row;
  sweep.column = column;
  sweep.crossing += count;
  return count;
}

// Whether a circle certainly crosses another one, or lies inside a cap as a whole: by the formulas of AmongLargeCaps in
// floats, the circle being one and the caps all, itself among them, of which nothing is certain. Where |d| < 1.2 its
// square has an error of 2.4 * 76 e, e = 2^-24, and the other product one of 95 e, below 512 e together; where it is
// larger, -q > 0.4. If -q > 512 e, |d| is above 512 e too.
bool has_covered_point(const CapPointers<float> &caps, uint32_t count, uint32_t circle) {
  const SomeCaps own = SomeCaps::all_of(caps, circle);
  const Floats one = Floats::all(1.0F), margin = Floats::all(Bounds::crossing);
  const Floats square = minus_fused(own.b, own.b, one);
  Floats covered = Floats::all(-4.0F);
  for (uint32_t t = 0; t < count; t += Floats::lanes) {
    const SomeCaps cap = SomeCaps::load(caps, t);
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
  store_large(sweep);
  keep_exposed(sweep);
  leave_out_covered_circles(sweep);
  sweep.row = 0;
  sweep.column = 1;
  sweep.crossing = 0;
}

uint32_t next_open_pairs(PairSweep &sweep, OpenPair *answers) {
  const uint32_t circles = sweep.exposed_count;
  if (sweep.row + 1 >= circles) return 0;
  OpenPoints open;
  if (circles <= PairsOfFew::most) {
    sweep.row = circles;
    const uint32_t points = open_points_of_few(sweep, open);
    const auto circles_of = [circles](uint32_t p) {
      return CirclePair{pairs_of_few.j[circles][p], pairs_of_few.k[circles][p]};
    };
    return answer(sweep, open, points, circles_of, answers);
  }
  Pairs pairs;
  const auto circles_of = [&pairs](uint32_t p) {
    return CirclePair{static_cast<uint32_t>(pairs.j[p]), static_cast<uint32_t>(pairs.k[p])};
  };
  while (sweep.row + 1 < circles) {
    const uint32_t count = add_pairs(sweep, pairs);
    const uint32_t points = open_points(pointers(sweep.by_size), sweep.class_end[0], pairs, count, open);
    const uint32_t found = answer(sweep, open, points, circles_of, answers);
    if (found > 0) return found;
  }
  return 0;
}

uint32_t uncrossed_caps(const PairSweep &sweep, uint32_t *caps) {
  uint32_t found = 0;
  for (uint32_t a = 0; a < sweep.exposed_count; a += Floats::lanes) {
    LaneBits left = first_lanes(sweep.exposed_count - a) & ~negative(Floats::load(sweep.crossed + a));
    for (; left != 0; left &= left - 1) {
      const uint32_t cap = static_cast<uint32_t>(sweep.exposed_cap[a + lowest(left)]);
      caps[found] = cap;
      found += static_cast<uint32_t>(!has_covered_point(pointers(sweep.caps), sweep.count, cap));
    }
  }
  return found;
}

}  // namespace hsp::HSP_TARGET
