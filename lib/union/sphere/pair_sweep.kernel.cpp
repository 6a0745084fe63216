// Finds in floats, among many caps, the pairs with a point that no cap certainly covers.
//
// As an example caps with b = 0.8, 0.3, 0.7, 0.9 and 0.1; a cap is the larger the smaller its b is:
//   class 0, b < 0.6      0.3  0.1        class_end[0] = 2
//   class 1, b < 0.8      0.7             class_end[1] = 3
// so that by_size is 0.3 0.1 0.7: in a class, caps stay in their order; 0.8 and 0.9, which cover little, are left out.
// The points of a batch of pairs are tested against these three caps first, and what is left of them against all five.
#include "sphere/pair_sweep.hpp"
#include "sphere/covered_circles.hpp"
#include "sphere/pairs_of_few.hpp"

namespace hsp::HSP_TARGET {
namespace {

using SomeCaps = LaneCaps<Floats>;
using SomePoints = LanePoints<Floats>;

// A cap whose height b is below the first number is in the first class, else below the second one in the second class.
// Caps of both classes are called large.
constexpr float class_limits[PairSweep::size_classes] = {0.6F, 0.8F};
constexpr uint32_t last_class = PairSweep::size_classes - 1;

CapPointers<float> pointers(const FloatCaps &caps) {
  return {caps.x, caps.y, caps.z, caps.b};
}

void store(const FloatCaps &to, uint32_t slot, const SomeCaps &caps) {
  caps.x.store(to.x + slot);
  caps.y.store(to.y + slot);
  caps.z.store(to.z + slot);
  caps.b.store(to.b + slot);
}

void store_chosen(const FloatCaps &to, uint32_t slot, const SomeCaps &caps, const FrontOrder &order) {
  store_front(to.x + slot, caps.x, order);
  store_front(to.y + slot, caps.y, order);
  store_front(to.z + slot, caps.z, order);
  store_front(to.b + slot, caps.b, order);
}

// The caps of the second class wait in the arrays of exposed circles until it is known where the first class ends.
void sort_by_size(PairSweep &sweep) {
  const CapPointers<float> from = pointers(sweep.caps), waiting = pointers(sweep.exposed);
  const FloatCaps to = sweep.by_size;
  const uint32_t count = sweep.count;
  const Floats first_limit = Floats::all(class_limits[0]), last_limit = Floats::all(class_limits[last_class]);
  uint32_t first_class = 0, second_class = 0;
  // Lanes after the last cap belong to no class.
  for (uint32_t k = 0; k < count; k += Floats::lanes) {
    const SomeCaps caps = SomeCaps::load(from, k);
    const LaneBits first = greater(first_limit, caps.b), second = greater(last_limit, caps.b) & ~first;
    store_chosen(to, first_class, caps, FrontOrder::of(first));
    store_chosen(sweep.exposed, second_class, caps, FrontOrder::of(second));
    first_class += ones(first);
    second_class += ones(second);
  }
  for (uint32_t k = 0; k < second_class; k += Floats::lanes) store(to, first_class + k, SomeCaps::load(waiting, k));
  sweep.class_end[0] = first_class;
  sweep.class_end[last_class] = first_class + second_class;
}

void store_large(PairSweep &sweep) {
  const CapPointers<float> from = pointers(sweep.by_size);
  const FloatCaps to = sweep.large;
  const uint32_t count = sweep.class_end[last_class];
  for (uint32_t k = 0; k < count; k += Floats::lanes) {
    store_as_fractions(SomeCaps::load(from, k), to.x + k, to.y + k, to.z + k, to.b + k);
  }
}

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

// Adds circles to the arrays of exposed circles. The added circles may come from the same arrays, if they stand at or
// behind the place where they are written.
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

// Keeps the circles that no single cap of the first class covers. Single caps of the second class cover few more, and
// leave_out_covered_circles() finds these as well.
void keep_exposed(PairSweep &sweep) {
  const CapPointers<float> caps = pointers(sweep.caps), large = pointers(sweep.large);
  const uint32_t count = sweep.count, largest_caps = sweep.class_end[0];
  ExposedCircles exposed(sweep);
  for (uint32_t j = sweep.first_later; j < count; j += 2 * Floats::lanes) {
    // Lanes after the last circle are left out below.
    const SomeCaps low = SomeCaps::load(caps, j), high = SomeCaps::load(caps, j + Floats::lanes);
    const AmongLargeCaps among(large, largest_caps, low, high);
    const Floats number = Floats::ascending() + Floats::all(static_cast<float>(j));
    exposed.keep(low, number, among.low_crossing(), first_lanes(count - j) & among.low_outside());
    if (j + Floats::lanes >= count) break;
    exposed.keep(high, number + Floats::all(static_cast<float>(Floats::lanes)), among.high_crossing(),
                 first_lanes(count - j - Floats::lanes) & among.high_outside());
  }
  end_exposed(sweep, exposed.kept());
}

// Leaves out circles that large caps certainly cover together. If there are few circles, testing their pairs is
// quicker.
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

// Crossing points that no cap has been found to cover so far. Their number is kept by the caller, as for CrossingPairs.
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

// Adds the points of pairs p, p + 1, .. that are in no cap of the first class. Returns how many points there are then.
[[gnu::always_inline]] inline uint32_t add_points(const CapPointers<float> &by_size, uint32_t first_class,
                                                  LaneCrossings<Floats> crossings, Floats q, uint32_t p, LaneBits valid,
                                                  OpenPoints &open, uint32_t count) {
  crossings.doubt_uncertain(q);
  const NotCovered open_lanes(by_size, 0, first_class, crossings.minus, crossings.plus);
  const Floats number = Floats::ascending() + Floats::all(static_cast<float>(p));
  count = open.keep(count, crossings.minus, number, valid & open_lanes.first);
  return open.keep(count, crossings.plus, number + Floats::all(static_cast<float>(PairSweep::batch)),
                   valid & open_lanes.second);
}

using Pairs = CrossingPairs<Floats, PairSweep::batch>;

// Finds the points of all pairs of the few exposed circles that are in no cap of the first class, without a branch that
// depends on which circles cross. Returns how many points these are.
uint32_t open_points_of_few(PairSweep &sweep, OpenPoints &open) {
  const CapPointers<float> by_size = pointers(sweep.by_size);
  const uint32_t circles = sweep.exposed_count, count = count_of_pairs(circles);
  const EightFloats x = EightFloats::load(sweep.exposed.x), y = EightFloats::load(sweep.exposed.y),
                    z = EightFloats::load(sweep.exposed.z), b = EightFloats::load(sweep.exposed.b);
  const auto caps_in_order = [&](const uint8_t *order) {
    return SomeCaps{x.in_order(order), y.in_order(order), z.in_order(order), b.in_order(order)};
  };
  uint32_t left = 0;
  for (uint32_t p = 0; p < count; p += Floats::lanes) {
    const SomeCaps u = caps_in_order(pairs_of_few.j[circles] + p), v = caps_in_order(pairs_of_few.k[circles] + p);
    const LanePairs<Floats> pair(u, v);
    const LaneBits crossing = first_lanes(count - p) & pair.may_cross();
    sweep.crossing += ones(crossing);
    left = add_points(by_size, sweep.class_end[0], {u, v, pair.g, pair.q}, pair.q, p, crossing, open, left);
  }
  sweep.row = circles;
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
    // No branch depends on how many there are.
    left = open.keep(left, b, pairs_b,
                     first_lanes(count - p > Floats::lanes ? count - p - Floats::lanes : 0) & open_lanes.second);
  }
  return left;
}

uint32_t cap_number(const PairSweep &sweep, uint32_t exposed) {
  return static_cast<uint32_t>(sweep.exposed_cap[exposed]);
}

struct CirclePair {
  uint32_t j, k;
};

// Tests the open points of a batch against the other large caps, then against all caps, and writes the pairs that have
// open points left. circles_of(p): the numbers of the exposed circles of pair p.
template <class CirclesOf>
uint32_t answer(const PairSweep &sweep, OpenPoints &open, uint32_t points, CirclesOf circles_of, OpenPair *answers) {
  points = leave_out_covered(pointers(sweep.by_size), sweep.class_end[0], sweep.class_end[last_class], open, points);
  const CapPointers<float> caps = pointers(sweep.caps);
  uint64_t doubtful = 0, minus = 0, plus = 0;
  for (uint32_t p = 0; p < points; ++p) {
    // No branch depends on the answer, which cannot be predicted.
    const PointState state = PointState::among(caps, sweep.count, open.in_all_lanes(p));
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
  uint32_t row = sweep.row, column = sweep.column, count = 0;
  while (row + 1 < exposed_count && !Pairs::is_full(count)) {
    const SomeCaps cap = SomeCaps::all_of(exposed, row);
    const Floats row_number = Floats::all(static_cast<float>(row));
    Floats numbers = Floats::ascending() + Floats::all(static_cast<float>(column));
    for (; column < exposed_count && !Pairs::is_full(count); column += Floats::lanes) {
      const SomeCaps others = SomeCaps::load(exposed, column);
      const LanePairs<Floats> pair(cap, others);
      count = pairs.add(count, row_number, cap, numbers, others, pair, pair.may_cross());
      numbers = numbers + Floats::all(static_cast<float>(Floats::lanes));
    }
    if (column >= exposed_count) column = ++row + 1;
  }
  sweep.row = row;
  sweep.column = column;
  sweep.crossing += count;
  return count;
}

// The same as open_points_of_few(), for the next pairs of many circles.
uint32_t open_points_of_many(PairSweep &sweep, Pairs &pairs, OpenPoints &open) {
  const CapPointers<float> by_size = pointers(sweep.by_size);
  const uint32_t first_class = sweep.class_end[0], count = add_pairs(sweep, pairs);
  uint32_t left = 0;
  for (uint32_t p = 0; p < count; p += Floats::lanes) {
    left = add_points(by_size, first_class, pairs.points(p), Floats::load(pairs.q + p), p, first_lanes(count - p), open,
                      left);
  }
  return left;
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
  const bool few = circles <= PairsOfFew::most;
  OpenPoints open;
  Pairs pairs;
  const auto circles_of = [&](uint32_t p) {
    return few ? CirclePair{pairs_of_few.j[circles][p], pairs_of_few.k[circles][p]}
               : CirclePair{static_cast<uint32_t>(pairs.j[p]), static_cast<uint32_t>(pairs.k[p])};
  };
  while (sweep.row + 1 < circles) {
    const uint32_t points = few ? open_points_of_few(sweep, open) : open_points_of_many(sweep, pairs, open);
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
