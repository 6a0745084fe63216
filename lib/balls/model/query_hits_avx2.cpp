// Balls eight at a time, and their indices in order without branches on them; for AVX2.
#if HSP_AVX2
#include "model/query_hits.hpp"

#include "exact/lattice.hpp"
#include "lanes/words.hpp"

namespace hsp {
namespace {

// One query in all lanes.
struct WideQuery {
  Doubles x, y, z, r;
};

// Four balls: their distances from the query, and the sums of the radii, squared.
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

// Of the eight balls from j on. Apart, and with the query in registers, so that loops around it need no room for what
// this leaves untouched.
[[gnu::noinline, gnu::cold]] LaneBits decided(const QueryArrays &balls, Doubles x, Doubles y, Doubles z, Doubles r,
                                              uint32_t j, LaneBits doubtful, LaneBits meet) {
  for (; doubtful != 0; doubtful &= doubtful - 1) {
    const uint32_t lane = lowest(doubtful), k = j + lane;
    const bool meets =
        meet_exactly(balls.x[k] - first(x), balls.y[k] - first(y), balls.z[k] - first(z), balls.r[k] + first(r));
    meet = (meet & ~(1U << lane)) | static_cast<LaneBits>(meets) << lane;
  }
  return meet;
}

// Of the eight balls from j on, those before ball `last` that meet the query. Upper halves of doubles tell their signs,
// and their sizes well enough for a doubt somewhat larger than meeting_doubt: within 2^-48 instead of 2^-49. A square
// of 0 has no doubt but that of an excess of 0; others are not below 1.
inline LaneBits meeting(const QueryArrays &balls, const WideQuery &query, uint32_t j, uint32_t last) {
  static_assert(meeting_doubt == 0x1p-49);
  const Squares low(balls, query, j), high(balls, query, size_t{j} + 4);
  const Integers excess = upper_halves(low.excess, high.excess);
  const Integers within = upper_halves(low.within, high.within);
  const Integers doubt = larger_signed(within - Integers::all(48U << 20), Integers::all(0));
  const Integers size = excess & Integers::all(INT32_MAX);
  const Integers valid = Integers::first_set(last - j);
  if (!all_greater(size, doubt, valid)) [[unlikely]] {
    const LaneBits doubtful = sign_bits(valid) & ~greater_signed(size, doubt);
    return decided(balls, query.x, query.y, query.z, query.r, j, doubtful, sign_bits(excess)) & sign_bits(valid);
  }
  return sign_bits(excess & valid);
}

// Adds the hits among the balls of the ranges. meeting_of(ids, j, last): which of the eight balls from j on, with these
// indices, are hits and before `last`.
template <class MeetingOf>
inline void add_hits_by(const QueryArrays &balls, const BallRange *ranges, uint32_t count, QueryHits &hits,
                        MeetingOf meeting_of) {
  uint32_t found = hits.count;
  for (const BallRange *range = ranges; range < ranges + count; ++range) {
    uint32_t j = range->first;
    const uint32_t last = range->last;
    // Nearly always once: that is easier to predict than steps of four.
    do {
      const Integers ids = Integers::load(balls.caller + j);
      const LaneBits meet = meeting_of(ids, j, last);
      store_front(hits.ids + (found < QueryHits::room ? found : QueryHits::room), ids, FrontOrder::of_eight(meet));
      found += ones(meet);
      j += 8;
    } while (j < last);
  }
  hits.count = found;
}

// The smaller one of each lane and that of `partners`; in the lanes of `takes_larger` the larger one.
template <int takes_larger>
inline Integers exchange(Integers a, Integers partners) {
  return {_mm256_blend_epi32(_mm256_min_epu32(a.v, partners.v), _mm256_max_epu32(a.v, partners.v), takes_larger)};
}
inline Integers with_next(Integers a) {  // 1 0 3 2 5 4 7 6
  return {_mm256_shuffle_epi32(a.v, 0xB1)};
}
inline Integers with_second_next(Integers a) {  // 2 3 0 1 6 7 4 5
  return {_mm256_shuffle_epi32(a.v, 0x4E)};
}
inline Integers with_fourth_next(Integers a) {  // 4 5 6 7 0 1 2 3
  return {_mm256_permute4x64_epi64(a.v, 0x4E)};
}
inline Integers reversed_fours(Integers a) {  // 3 2 1 0 7 6 5 4
  return {_mm256_shuffle_epi32(a.v, 0x1B)};
}
inline Integers reversed(Integers a) {  // 7 6 5 4 3 2 1 0
  return reversed_fours(with_fourth_next(a));
}

// Batcher's bitonic sorter (Knuth, TAOCP 3, section 5.3.4).
inline Integers sorted_halves(Integers a) {  // of eight lanes whose halves of four are bitonic
  a = exchange<0xCC>(a, with_second_next(a));
  return exchange<0xAA>(a, with_next(a));
}
inline Integers sorted_bitonic(Integers a) {
  return sorted_halves(exchange<0xF0>(a, with_fourth_next(a)));
}
inline Integers sorted(Integers a) {
  a = exchange<0xAA>(a, with_next(a));
  a = exchange<0xCC>(a, reversed_fours(a));
  a = exchange<0xAA>(a, with_next(a));
  return sorted_halves(exchange<0xF0>(a, reversed(a)));
}

// The first `count` ids of eight; larger than all others in the lanes beyond.
inline Integers load_ids(const uint32_t *ids, uint32_t count) {
  const Integers beyond = {_mm256_cmpgt_epi32(Integers::ascending().v, Integers::all(count - 1).v)};
  return {_mm256_or_si256(Integers::load(ids).v, beyond.v)};
}
// To where there is room for `room` ids; what stands behind those stored stays. A store of some lanes alone is slow on
// many processors.
inline void store_ids(uint32_t *ids, Integers a, uint32_t count, uint32_t room) {
  const Integers wanted = Integers::first_set(count);
  if (room >= Integers::lanes) [[likely]] {
    chosen(wanted, a, Integers::load(ids)).store(ids);
  } else {
    _mm256_maskstore_epi32(reinterpret_cast<int *>(ids), wanted.v, a.v);
  }
}

// No more than eight hits, in ascending order.
inline void write_few_ascending(const QueryHits &hits, uint32_t *ids, uint32_t room) {
  store_ids(ids, sorted(load_ids(hits.ids, hits.count)), hits.count, room);
}

// Two sorted halves of `half` eights each, a power of two, to one.
inline void merge(Integers *eights, uint32_t half) {
  const auto exchange_whole = [](Integers &a, Integers &b, Integers partner) {
    b = {_mm256_max_epu32(a.v, partner.v)};
    a = {_mm256_min_epu32(a.v, partner.v)};
  };
  // Smallest against largest, after which each half is bitonic. The upper half comes out in reversed order.
  Integers *const upper = eights + half;
  for (uint32_t k = 0; k < half; ++k) exchange_whole(eights[k], upper[half - 1 - k], reversed(upper[half - 1 - k]));
  for (uint32_t stride = half / 2; stride > 0; stride /= 2) {
    for (uint32_t first = 0; first < 2 * half; first += 2 * stride) {
      for (uint32_t k = first; k < first + stride; ++k)
        exchange_whole(eights[k], eights[k + stride], eights[k + stride]);
    }
  }
  for (uint32_t k = 0; k < 2 * half; ++k) eights[k] = sorted_bitonic(eights[k]);
}

}  // namespace

void add_hits_avx2(const QueryArrays &balls, const QueryBall &query, const BallRange *ranges, uint32_t count,
                   QueryHits &hits) {
  const Integers excluded = Integers::all(query.excluded);
  const WideQuery wide{Doubles::all(query.x), Doubles::all(query.y), Doubles::all(query.z), Doubles::all(query.r)};
  // In registers: of one copy the compiler makes vectors, which have to wait for what has just been stored.
  const QueryArrays arrays{balls.x, balls.y, balls.z, balls.r, balls.caller};
  add_hits_by(arrays, ranges, count, hits, [&](Integers ids, uint32_t j, uint32_t last) {
    return meeting(arrays, wide, j, last) & ~equal(ids, excluded);
  });
}

void write_ascending_avx2(const QueryHits &hits, uint32_t *ids, uint32_t room) {
  const uint32_t count = hits.count;
  if (count <= 8) return write_few_ascending(hits, ids, room);
  // A power of two of eights, sorted each, then merged two by two.
  Integers eights[QueryHits::room / 8];
  uint32_t used = 0;
  for (; 8 * used < count; ++used) {
    eights[used] = sorted(load_ids(hits.ids + 8 * used, count - 8 * used));
  }
  uint32_t all = used;
  for (; (all & (all - 1)) != 0; ++all) eights[all] = Integers::all(UINT32_MAX);
  for (uint32_t half = 1; half < all; half *= 2) {
    for (uint32_t first = 0; first < all; first += 2 * half) merge(eights + first, half);
  }
  for (uint32_t k = 0; k + 1 < used; ++k) eights[k].store(ids + 8 * k);
  const uint32_t before = 8 * (used - 1);
  store_ids(ids + before, eights[used - 1], count - before, room - before);
}

namespace {

// floor(value / side) for integers below 2^52 in size, as CubeAxis::cube_at of grid_order.hpp.
Doubles cubes_at(const QueryGrid &grid, Doubles value) {
  const Doubles side = Doubles::all(grid.side);
  const Doubles quotient = truncated(value * Doubles::all(grid.inverse_side));
  const Doubles rest = value - quotient * side;
  return quotient - (Doubles::all(1.0) - one_where_not_less(rest, Doubles::all(0.0))) + one_where_not_less(rest, side);
}

// A query among balls that are rounded to floats.
class RoundedQuery {
 public:
  // `ball`: x, y, z, r on the lattice.
  RoundedQuery(const QueryGrid &grid, const QueryArrays &balls, Doubles ball, double reach)
      : rounded_(grid.rounded), balls_(balls), ball_(ball) {
    const Doubles from_middle = ball - Doubles::load(grid.middle);
    const Floats at = to_floats(from_middle, from_middle);
    x_ = in_all_lanes<0>(at);
    y_ = in_all_lanes<1>(at);
    z_ = in_all_lanes<2>(at);
    r_ = in_all_lanes<3>(at);
    doubt_ = Floats::all(static_cast<float>(rounded_doubt(grid.extent, reach)));
  }

  // Of the eight balls from j on, those before ball `last` that meet the query.
  LaneBits meeting(uint32_t j, uint32_t last) const {
    const FourOfEight ball = FourOfEight::load(rounded_ + 4 * size_t{j});
    const Floats dx = x_ - ball.a, dy = y_ - ball.b, dz = z_ - ball.c, sum = r_ + ball.d;
    const Floats excess = fused(dz, dz, fused(dy, dy, fused_minus(dx, dx, sum * sum)));
    const LaneBits valid = first_lanes(last - j);
    if ((not_greater(magnitude(excess), doubt_) & valid) != 0) [[unlikely]]
      return by_doubles(balls_, ball_, j, last);
    return negative(excess) & valid;
  }

 private:
  // Apart, as decided().
  [[gnu::noinline, gnu::cold]] static LaneBits by_doubles(const QueryArrays &balls, Doubles ball, uint32_t j,
                                                          uint32_t last) {
    return hsp::meeting(
        balls, {in_all_lanes<0>(ball), in_all_lanes<1>(ball), in_all_lanes<2>(ball), in_all_lanes<3>(ball)}, j, last);
  }

  const float *rounded_;
  const QueryArrays &balls_;
  Doubles ball_;
  Floats x_, y_, z_, r_, doubt_;
};

// Parts of rows of cubes. Whether a row has more than eight balls cannot be predicted, so that what is behind them is a
// range of its own.
struct Rows {
  static constexpr uint32_t most = 9;
  BallRange range[2 * most + 1];
  uint32_t count = 0;

  // Those of the cubes from `low` to `high` in which there are balls. False if there are too many rows.
  bool find(const QueryGrid &grid, Doubles low, Doubles high) {
    const Doubles origin = Doubles::load(grid.low), size = Doubles::load(grid.size), zero = Doubles::all(0.0);
    const auto clipped = [&](Doubles cube) { return smaller(larger(cube - origin, zero), size); };
    uint32_t from[4], to[4];
    store_integers(from, clipped(low));
    store_integers(to, clipped(high + Doubles::all(1.0)));
    if (uint64_t{to[1] - from[1]} * (to[2] - from[2]) > most) return false;
    for (uint32_t z = from[2]; z < to[2]; ++z) {
      const uint32_t *row = grid.cells + (z * grid.layer + from[1]) * grid.row;
      for (uint32_t y = from[1]; y < to[1]; ++y, row += grid.row) {
        const uint32_t first = row[from[0]], last = row[to[0]];
        const uint32_t eight = first + 8;
        range[count] = {first, last < eight ? last : eight};
        count += static_cast<uint32_t>(first != last);
        range[count] = {eight, last};
        count += static_cast<uint32_t>(last > eight);
      }
    }
    return true;
  }
};

// The rest of a query for a ball on the lattice. Inlined: where a function with a wide argument is called last, GCC 12
// leaves the upper halves of registers in use, which makes all code behind it slow.
template <class Excluded>
[[gnu::always_inline]] inline bool find_around(const QueryGrid &grid, const QueryArrays &balls, Doubles ball,
                                               Excluded excluded, uint32_t *ids, uint32_t capacity, uint32_t &hits) {
  if (grid.rounded == nullptr) return false;
  const Doubles reach = in_all_lanes<3>(ball) + Doubles::all(grid.largest_radius);
  Rows rows;
  if (!rows.find(grid, cubes_at(grid, ball - reach), cubes_at(grid, ball + reach))) return false;
  QueryHits found;
  found.count = 0;
  const RoundedQuery query(grid, balls, ball, first(reach));
  add_hits_by(balls, rows.range, rows.count, found, [&query, &excluded](Integers others, uint32_t j, uint32_t last) {
    return query.meeting(j, last) & ~excluded(others);
  });
  if (found.count > QueryHits::room) return false;
  hits = found.count;
  if (found.count > capacity) return true;
  if (found.count <= 8) {
    write_few_ascending(found, ids, capacity);
  } else {
    write_ascending_avx2(found, ids, capacity);
  }
  return true;
}

}  // namespace

bool find_balls_avx2(const QueryGrid &grid, const QueryArrays &balls, const double *xyz, double radius, uint32_t *ids,
                     uint32_t capacity, uint32_t &hits) {
  // The position and the radius on the lattice: Lattice::round() and nearest().
  constexpr double c = exact::coordinate_limit;
  constexpr double least[4] = {-c, -c, -c, 0.0}, most[4] = {c, c, c, exact::query_radius_limit};
  const Doubles steps = Doubles::of(xyz[0], xyz[1], xyz[2], radius) * Doubles::all(grid.factor);
  const LaneBits good = not_less(steps, Doubles::load(least)) & not_less(Doubles::load(most), steps);
  if (good != 15U || grid.factor == 0.0) return false;
  const Doubles half = Doubles::all(0.5);
  const Doubles whole = truncated(steps), rest = steps - whole;
  const Doubles ball = whole + one_where_not_less(rest, half) - one_where_not_less(-half, rest);
  return find_around(
      grid, balls, ball, [](Integers) { return LaneBits{0}; }, ids, capacity, hits);
}

bool find_neighbours_avx2(const QueryGrid &grid, const QueryArrays &balls, uint32_t rank, uint32_t *ids,
                          uint32_t capacity, uint32_t &hits) {
  if (grid.cells == nullptr) return false;
  const Doubles ball = Doubles::of(balls.x[rank], balls.y[rank], balls.z[rank], balls.r[rank]);
  const Integers own = Integers::all(balls.caller[rank]);
  return find_around(
      grid, balls, ball, [own](Integers others) { return equal(others, own); }, ids, capacity, hits);
}

}  // namespace hsp
#endif
