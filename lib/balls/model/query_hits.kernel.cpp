// Tests as many balls at a time as a register holds floats, and sorts their indices without branches on them.
//
// As an example a query of radius 2 at 0 and balls j to j + 3 of radius 1 with centres on the x axis:
//   x                  2    3    4    5
//   within             9    9    9    9      the square of 2 + 1
//   excess            -5    0    7   16      x^2 less that: below 0 the ball meets the query, above 0 it does not
//   certain           yes   no  yes  yes     whether it is farther from 0 than meeting_doubt times `within`
// Ball j + 1 is left to integers, which find 9 <= 9: it touches, and so meets. Hits are j and j + 1, bits 0011.
#include "model/query_hits.hpp"

#include "exact/lattice.hpp"
#include "lanes/four_doubles.hpp"
#include "model/meeting_lanes.hpp"

namespace hsp::HSP_TARGET {
namespace {

// One query in all lanes.
struct WideQuery {
  Doubles x, y, z, r;
};

// For some balls: within = t^2 and excess = d^2 - t^2, with the d and t of meeting.hpp.
struct Squares {
  Doubles excess, within;

  Squares(const QueryArrays &balls, const WideQuery &query, size_t j) {
    const Doubles dx = query.x - Doubles::load(balls.x + j);
    const Doubles dy = query.y - Doubles::load(balls.y + j);
    const Doubles dz = query.z - Doubles::load(balls.z + j);
    const Doubles sum = query.r + Doubles::load(balls.r + j);
    within = sum * sum;
    excess = fused(dz, dz, fused(dy, dy, fused_minus(dx, dx, within)));
  }
};

// Decides about doubtful lanes, for the balls from j on. Out of line, with the query in registers, so that the loops
// around the call keep their own registers.
[[gnu::noinline, gnu::cold]] LaneBits decided_by_integers(const QueryArrays &balls, Doubles x, Doubles y, Doubles z,
                                                          Doubles r, uint32_t j, LaneBits doubtful, LaneBits meet) {
  return decided(doubtful, meet, [&](uint32_t lane) {
    const uint32_t k = j + lane;
    return meet_exactly(balls.x[k] - first(x), balls.y[k] - first(y), balls.z[k] - first(z), balls.r[k] + first(r));
  });
}

// The balls from j on, before ball `last`, that meet the query. The upper halves of doubles are compared as integers:
// they have the sign, and are in the order of sizes. As meeting_doubt is a power of two, it is subtracted from the
// exponent. If t^2 is 0, only an excess of 0 is in doubt; other squares are not below 1.
inline LaneBits meeting(const QueryArrays &balls, const WideQuery &query, uint32_t j, uint32_t last) {
  static_assert(meeting_doubt == 0x1p-50);
  const Squares low(balls, query, j), high(balls, query, size_t{j} + Doubles::lanes);
  const Integers excess = upper_halves(low.excess, high.excess);
  const Integers within = upper_halves(low.within, high.within);
  const Integers doubt = larger_signed(within - Integers::all(50U << 20), Integers::all(0));
  const Integers size = excess & Integers::all(INT32_MAX);
  const Integers valid = Integers::first_set(last - j);
  if (!all_greater(size, doubt, valid)) [[unlikely]] {
    const LaneBits doubtful = sign_bits(valid) & ~greater_signed(size, doubt);
    return decided_by_integers(balls, query.x, query.y, query.z, query.r, j, doubtful, sign_bits(excess)) &
           sign_bits(valid);
  }
  return sign_bits(excess & valid);
}

// Adds the hits among the balls of the ranges. meeting_of(ids, j, last): which of the balls from j on, with these
// indices, are hits and before `last`.
template <class MeetingOf>
inline void add_hits_by(const QueryArrays &balls, const BallRange *ranges, uint32_t count, QueryHits &hits,
                        MeetingOf meeting_of) {
  uint32_t found = hits.count;
  for (const BallRange *range = ranges; range < ranges + count; ++range) {
    uint32_t j = range->first;
    const uint32_t last = range->last;
    // Nearly always this runs once, which is easier to predict than smaller steps.
    do {
      const Integers ids = Integers::load(balls.caller + j);
      const LaneBits meet = meeting_of(ids, j, last);
      store_front(hits.ids + (found < QueryHits::room ? found : QueryHits::room), ids, FrontOrder::of(meet));
      found += ones(meet);
      j += Floats::lanes;
    } while (j < last);
  }
  hits.count = found;
}

// The first `count` ids; lanes beyond hold a number larger than all ids.
inline Integers load_ids(const uint32_t *ids, uint32_t count) {
  return (Integers::load(ids) | Integers::all_set_from(count)) & Integers::all(INT32_MAX);
}
// Stores `count` ids to an array of `room` entries; other entries keep their values. A store of some lanes alone is
// slow on many processors, so that whole registers are written if there is room.
inline void store_ids(uint32_t *ids, Integers a, uint32_t count, uint32_t room) {
  if (room >= Integers::lanes) [[likely]] {
    chosen(Integers::first_set(count), a, Integers::load(ids)).store(ids);
  } else {
    store_first(ids, a, count);
  }
}

// Writes the hits in ascending order; these are no more than there are lanes.
inline void write_few_ascending(const QueryHits &hits, uint32_t *ids, uint32_t room) {
  store_ids(ids, sorted(load_ids(hits.ids, hits.count)), hits.count, room);
}

// Writes the hits in ascending order by bits, one for each number of a range of 2^11 numbers that begins at a multiple
// of 2^11. False if no such range has all hits. There are at least as many hits as lanes.
inline bool write_as_bits(const QueryHits &hits, uint32_t *ids) {
  constexpr uint32_t word_bits = 64, most_words = 32;
  const uint32_t count = hits.count, any = hits.ids[0], last_word = count - Integers::lanes;
  Integers different = Integers::load(hits.ids + last_word) ^ Integers::all(any);
  for (uint32_t k = 0; k < last_word; k += Integers::lanes) {
    different = different | (Integers::load(hits.ids + k) ^ Integers::all(any));
  }
  uint32_t lane[Integers::lanes], bits = 1;
  different.store(lane);
  for (const uint32_t each : lane) bits |= each;
  if (bits >= word_bits * most_words) return false;
  const uint32_t first = any & ~(UINT32_MAX >> __builtin_clz(bits));
  const uint32_t words = (any | bits) / word_bits - first / word_bits;
  uint64_t set[most_words];
  for (uint32_t word = 0; word <= words; ++word) set[word] = 0;
  for (uint32_t k = 0; k < count; ++k) {
    const uint32_t at = hits.ids[k] - first;
    set[at / word_bits] |= uint64_t{1} << at % word_bits;
  }
  for (uint32_t word = 0; word <= words; ++word) {
    for (uint64_t left = set[word]; left != 0; left &= left - 1) {
      *ids++ = first + word * word_bits + static_cast<uint32_t>(__builtin_ctzll(left));
    }
  }
  return true;
}

// Merges two sorted halves of `half` words each, a power of two: Batcher's bitonic merge (Knuth, TAOCP 3, section
// 5.3.4).
inline void merge(Integers *words, uint32_t half) {
  const auto exchange_whole = [](Integers &a, Integers &b, Integers partner) {
    b = larger_signed(a, partner);
    a = smaller_signed(a, partner);
  };
  // The smallest is compared with the largest, and so on; after that each half is bitonic. The upper half comes out in
  // reversed order.
  Integers *const upper = words + half;
  for (uint32_t k = 0; k < half; ++k) exchange_whole(words[k], upper[half - 1 - k], reversed(upper[half - 1 - k]));
  for (uint32_t stride = half / 2; stride > 0; stride /= 2) {
    for (uint32_t first = 0; first < 2 * half; first += 2 * stride) {
      for (uint32_t k = first; k < first + stride; ++k) {
        exchange_whole(words[k], words[k + stride], words[k + stride]);
      }
    }
  }
  for (uint32_t k = 0; k < 2 * half; ++k) words[k] = sorted_bitonic(words[k]);
}

}  // namespace

void add_hits_in_lanes(const QueryArrays &balls, const QueryBall &query, const BallRange *ranges, uint32_t count,
                       QueryHits &hits) {
  const Integers excluded = Integers::all(query.excluded);
  const WideQuery wide{Doubles::all(query.x), Doubles::all(query.y), Doubles::all(query.z), Doubles::all(query.r)};
  // Copied pointer by pointer, to registers: a copy of the whole struct becomes vectors, which have to wait for
  // pointers that have just been stored.
  const QueryArrays arrays{balls.x, balls.y, balls.z, balls.r, balls.caller};
  add_hits_by(arrays, ranges, count, hits, [&](Integers ids, uint32_t j, uint32_t last) {
    return meeting(arrays, wide, j, last) & ~equal(ids, excluded);
  });
}

uint32_t near_query_in_lanes(const RoundedQueryBall &query, const float *rounded, const uint32_t *ids,
                             const BallRange *ranges, uint32_t count, uint32_t *near) {
  const float *const at = query.ball;
  const FloatBall ball{Floats::all_of(at), Floats::all_of(at + 1), Floats::all_of(at + 2), Floats::all_of(at + 3)};
  const Floats doubt = Floats::all(query.doubt);
  uint32_t found = 0;
  for (const BallRange *range = ranges; range < ranges + count; ++range) {
    uint32_t j = range->first;
    do {
      const FourOfEach other = FourOfEach::load(rounded + 4 * size_t{j});
      const Floats excess = ball.excess(other.a, other.b, other.c, other.d);
      const LaneBits may_meet = not_less(doubt, excess) & first_lanes(range->last - j);
      store_front(near + found, Integers::load(ids + j), FrontOrder::of(may_meet));
      found += ones(may_meet);
      j += Floats::lanes;
    } while (j < range->last);
  }
  return found;
}

void write_ascending_in_lanes(const QueryHits &hits, uint32_t *ids, uint32_t room) {
  constexpr uint32_t n = Integers::lanes;
  const uint32_t count = hits.count;
  if (count <= n) return write_few_ascending(hits, ids, room);
  // In registers of four lanes more hits take longer to sort.
  if (n == 4 && count > 4 * n && write_as_bits(hits, ids)) return;
  // Sorts each word, fills up to a power of two of words, then merges two by two.
  Integers words[QueryHits::room / n];
  uint32_t used = 0;
  for (; n * used < count; ++used) words[used] = sorted(load_ids(hits.ids + n * used, count - n * used));
  uint32_t all = used;
  for (; (all & (all - 1)) != 0; ++all) words[all] = Integers::all(INT32_MAX);
  for (uint32_t half = 1; half < all; half *= 2) {
    for (uint32_t first = 0; first < all; first += 2 * half) merge(words + first, half);
  }
  for (uint32_t k = 0; k + 1 < used; ++k) words[k].store(ids + n * k);
  const uint32_t before = n * (used - 1);
  store_ids(ids + before, words[used - 1], count - before, room - before);
}

namespace {

// 1 where a >= b, else 0.
FourDoubles one_where_not_less(const FourDoubles &a, const FourDoubles &b) {
  return Four::kept(a >= b, Four::all(1.0));
}

// floor(value / side) for integers below 2^52 in size, as CubeAxis::cube_at of grid_order.hpp.
FourDoubles cubes_at(const QueryGrid &grid, const FourDoubles &value) {
  const FourDoubles side = Four::all(grid.side), one = Four::all(1.0);
  const FourDoubles quotient = Four::truncated(value * Four::all(grid.inverse_side));
  const FourDoubles rest = value - quotient * side;
  return quotient - (one - one_where_not_less(rest, Four::all(0.0))) + one_where_not_less(rest, side);
}

// A query among balls that are rounded to floats.
class RoundedQuery {
 public:
  // `ball`: x, y, z, r on the lattice.
  RoundedQuery(const QueryGrid &grid, const QueryArrays &balls, const double (&ball)[4], double reach)
      : rounded_(grid.rounded), balls_(balls), ball_(ball) {
    float at[4];
    Four::store_as_floats(at, Four::load(ball) - Four::load(grid.middle));
    float_ball_ = {Floats::all_of(at), Floats::all_of(at + 1), Floats::all_of(at + 2), Floats::all_of(at + 3)};
    doubt_ = Floats::all(static_cast<float>(doubt_within(grid.extent, reach)));
  }

  // The balls from j on, before ball `last`, that meet the query.
  LaneBits meeting(uint32_t j, uint32_t last) const {
    const FourOfEach other = FourOfEach::load(rounded_ + 4 * size_t{j});
    const Floats excess = float_ball_.excess(other.a, other.b, other.c, other.d);
    const LaneBits valid = first_lanes(last - j);
    if ((not_greater(magnitude(excess), doubt_) & valid) != 0) [[unlikely]]
      return by_doubles(balls_, ball_, j, last);
    return negative(excess) & valid;
  }

 private:
  // Out of line, as decided_by_integers().
  [[gnu::noinline, gnu::cold]] static LaneBits by_doubles(const QueryArrays &balls, const double *ball, uint32_t j,
                                                          uint32_t last) {
    const WideQuery query{Doubles::all_of(ball), Doubles::all_of(ball + 1), Doubles::all_of(ball + 2),
                          Doubles::all_of(ball + 3)};
    return HSP_TARGET::meeting(balls, query, j, last);
  }

  const float *rounded_;
  const QueryArrays &balls_;
  const double *ball_;
  FloatBall float_ball_;
  Floats doubt_;
};

// Ranges of balls from rows of cubes. A branch on whether a row has more balls than are tested at once could not be
// predicted. So the balls behind these are a range of their own.
struct Rows {
  static constexpr uint32_t most = 9, at_once = Floats::lanes;
  BallRange range[2 * most + 1];
  uint32_t count = 0;

  // Finds the ranges of the cubes from `low` to `high`. False if there are too many rows.
  bool find(const QueryGrid &grid, const FourDoubles &low, const FourDoubles &high) {
    const FourDoubles origin = Four::load(grid.low), size = Four::load(grid.size);
    const auto store_clipped = [&](uint32_t *cubes, const FourDoubles &cube) {
      Four::store_truncated(cubes, Four::smaller(Four::larger(cube - origin, Four::all(0.0)), size));
    };
    uint32_t from[4], to[4];
    store_clipped(from, low);
    store_clipped(to, high + Four::all(1.0));
    if (uint64_t{to[1] - from[1]} * (to[2] - from[2]) > most) return false;
    for (uint32_t z = from[2]; z < to[2]; ++z) {
      const uint32_t *row = grid.cells + (z * grid.layer + from[1]) * grid.row;
      for (uint32_t y = from[1]; y < to[1]; ++y, row += grid.row) {
        const uint32_t first = row[from[0]], last = row[to[0]];
        const uint32_t later = first + at_once;
        range[count] = {first, last < later ? last : later};
        count += static_cast<uint32_t>(first != last);
        range[count] = {later, last};
        count += static_cast<uint32_t>(last > later);
      }
    }
    return true;
  }
};

// The rest of a query, for a ball on the lattice. Inlined: GCC 12, where a function with a wide argument is called
// last, leaves the upper halves of registers in use, which makes all code behind it slow.
template <class Excluded>
[[gnu::always_inline]] inline bool find_around(const QueryGrid &grid, const QueryArrays &balls, const FourDoubles &at,
                                               Excluded excluded, uint32_t *ids, uint32_t capacity, uint32_t &hits) {
  if (grid.rounded == nullptr) return false;
  double ball[4];
  Four::store(ball, at);
  const double reach = ball[3] + grid.largest_radius;
  Rows rows;
  if (!rows.find(grid, cubes_at(grid, at - Four::all(reach)), cubes_at(grid, at + Four::all(reach)))) return false;
  QueryHits found;
  found.count = 0;
  const RoundedQuery query(grid, balls, ball, reach);
  add_hits_by(balls, rows.range, rows.count, found, [&query, &excluded](Integers others, uint32_t j, uint32_t last) {
    return query.meeting(j, last) & ~excluded(others);
  });
  if (found.count > QueryHits::room) return false;
  hits = found.count;
  if (found.count > capacity) return true;
  if (found.count <= Integers::lanes) {
    write_few_ascending(found, ids, capacity);
  } else {
    HSP_TARGET::write_ascending_in_lanes(found, ids, capacity);
  }
  return true;
}

}  // namespace

bool find_balls_in_lanes(const QueryGrid &grid, const QueryArrays &balls, const double *xyz, double radius,
                         uint32_t *ids, uint32_t capacity, uint32_t &hits) {
  // The position and the radius on the lattice: Lattice::round() and nearest().
  constexpr double c = exact::coordinate_limit;
  constexpr double least[4] = {-c, -c, -c, 0.0}, most[4] = {c, c, c, exact::query_radius_limit};
  const FourDoubles steps = Four::of(xyz[0], xyz[1], xyz[2], radius) * Four::all(grid.factor);
  const uint64_t good = Four::set_lanes(steps >= Four::load(least)) & Four::set_lanes(Four::load(most) >= steps);
  if (good != 15U || grid.factor == 0.0) return false;
  const FourDoubles whole = Four::truncated(steps), rest = steps - whole;
  const FourDoubles ball = whole + one_where_not_less(rest, Four::all(0.5)) - one_where_not_less(Four::all(-0.5), rest);
  return find_around(
      grid, balls, ball, [](Integers) { return LaneBits{0}; }, ids, capacity, hits);
}

bool find_neighbours_in_lanes(const QueryGrid &grid, const QueryArrays &balls, uint32_t rank, uint32_t *ids,
                              uint32_t capacity, uint32_t &hits) {
  if (grid.cells == nullptr) return false;
  const FourDoubles ball = Four::of(balls.x[rank], balls.y[rank], balls.z[rank], balls.r[rank]);
  const Integers own = Integers::all(balls.caller[rank]);
  return find_around(
      grid, balls, ball, [own](Integers others) { return equal(others, own); }, ids, capacity, hits);
}

}  // namespace hsp::HSP_TARGET
