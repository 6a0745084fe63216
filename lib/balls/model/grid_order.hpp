// Grid order: the balls by the z, the y and then the x of their cubes, and in one cube by rank. So the cubes of one
// row, with equal y and z, follow each other, and so do the balls of neighbouring cubes of a row: one search in the
// hash table finds all of them. The order depends on the balls alone and not on the order of the input, except for
// balls that are equal. So nothing that runs in the order of ids depends on the order of the input.
//
// Balls come from a source, which may compute them when they are asked for: source.centre(i) and source.ball(i) are
// ball i on the lattice.
//
// As an example a plane with six balls, A to F, in cubes of side 10; A has a lower rank than B, and D than E:
//       y |
//     10  |   D   E |       |   F
//      0  |   A   B |   C   |             order:  A B | C | D E | F      cubes (0,0) (1,0) (0,1) (2,1)
//         +---------------------- x
//             0        10      20
// The neighbours of C are in the cubes from (0,-1) to (2,1): in the row y = 0 these have A to C, in the row y = 10 D to
// F.
#pragma once

#include <bit>
#include <initializer_list>

#include "core/small_code.hpp"
#include "core/sorting.hpp"
#include "model/ball_range.hpp"
#include "model/ball_set.hpp"
#include "model/cube_list.hpp"
#include "model/digit_sort.hpp"

namespace hsp {

// Finds in which cube of side `side` a coordinate lies, or a point.
class CubeAxis {
 public:
  explicit CubeAxis(int64_t side) : side_(side), reciprocal_(1.0 / static_cast<double>(side)) {}

  // floor(value / side) for |value| < 2^52. The estimate has an error below |value| 2^-52 / side < 1 / side, while a
  // quotient that is no integer is at least 1 / side away from the next one: so truncation is off by at most one, and
  // the sign and size of the remainder show it.
  HSP_INLINE_UNLESS_SMALL int64_t cube_at(int64_t value) const {
    const int64_t quotient = static_cast<int64_t>(static_cast<double>(value) * reciprocal_);
    const int64_t rest = value - quotient * side_;
    return quotient - static_cast<int64_t>(rest < 0) + static_cast<int64_t>(rest >= side_);
  }
  int64_t side() const { return side_; }
  HSP_INLINE_UNLESS_SMALL CubeCoordinates cube_at(const exact::Vector &point) const {
    return {cube_at(point.x), cube_at(point.y), cube_at(point.z)};
  }

 private:
  int64_t side_;
  double reciprocal_;
};

// Scratch memory: two numbers for each ball in each of the first two arrays, and counters as DigitSort needs. The order
// will be in `entries`.
struct GridOrderScratch {
  Span<uint32_t> entries, other_entries, counters;
};

// Balls in grid order, by their numbers in the source. A cube is cut into slices along x. If keys tell cubes, balls of
// one slice may not be in order yet: few are not, and sort_slice() sorts these when balls are read anyway.
struct GridOrder {
  Span<uint32_t> entries;  // [2 n] a key and a ball each
  bool keys_tell_cubes;    // whether two balls are in one cube iff their keys agree above the lowest slice_bits bits
  uint32_t slice_bits;
  uint32_t bits_in_slice;  // the lowest bits of keys, in which keys of one slice may differ

  uint32_t size() const { return entries.size() / 2; }
  uint32_t ball(uint32_t k) const { return entries[2 * k + 1]; }
  uint32_t key(uint32_t k) const { return entries[2 * k]; }
  uint64_t cube_key(uint32_t k) const { return uint64_t{key(k)} >> slice_bits; }
  bool same_slice(uint32_t k, uint32_t l) const { return (key(k) ^ key(l)) >> bits_in_slice == 0; }
};

// Numbers the cubes of a box in grid order, or their slices, into which each is cut along x, all of one width. Also
// numbers the cubes along each axis, from 0 on.
class CubeNumbers {
 public:
  CubeNumbers(const LatticeBox &box, const CubeAxis &axis) : axis_(axis), first_(axis.cube_at(box.low)) {
    const CubeCoordinates last = axis.cube_at(box.high);
    count_x_ = static_cast<uint64_t>(last.x - first_.x) + 1;
    count_y_ = static_cast<uint64_t>(last.y - first_.y) + 1;
    count_z_ = static_cast<uint64_t>(last.z - first_.z) + 1;
    slice(0);
  }
  void slice(uint32_t bits) {
    slice_bits_ = bits;
    slices_per_step_ = static_cast<double>(UINT64_C(1) << bits) / static_cast<double>(axis_.side());
  }

  // The number of cubes of the box, rounded.
  double cubes() const {
    return static_cast<double>(count_x_) * static_cast<double>(count_y_) * static_cast<double>(count_z_);
  }
  // The number of bits of slice numbers, if there are no more than 2^64 slices; and of the numbers along each axis.
  uint32_t bits() const { return bits_below((count_x_ * count_y_ * count_z_) << slice_bits_); }
  uint32_t bits_x() const { return bits_below(count_x_); }
  uint32_t bits_y() const { return bits_below(count_y_); }
  uint32_t bits_z() const { return bits_below(count_z_); }

  // The number of the slice in which a centre lies. In units of slices, `inside` is below the number of slices of a
  // cube by at least 1 / side of that number, so that rounding does not reach it.
  uint64_t operator()(const exact::Vector &centre) const {
    const int64_t x = axis_.cube_at(centre.x);
    const double inside = static_cast<double>(centre.x - x * axis_.side());
    const uint64_t row = z(centre) * count_y_ + y(centre);
    const uint64_t cube = row * count_x_ + static_cast<uint64_t>(x - first_.x);
    return (cube << slice_bits_) + static_cast<uint64_t>(static_cast<int64_t>(inside * slices_per_step_));
  }
  uint64_t x(const exact::Vector &centre) const { return static_cast<uint64_t>(axis_.cube_at(centre.x) - first_.x); }
  uint64_t y(const exact::Vector &centre) const { return static_cast<uint64_t>(axis_.cube_at(centre.y) - first_.y); }
  uint64_t z(const exact::Vector &centre) const { return static_cast<uint64_t>(axis_.cube_at(centre.z) - first_.z); }
  uint64_t along(int axis, const exact::Vector &centre) const {
    return axis == 0 ? x(centre) : axis == 1 ? y(centre) : z(centre);
  }
  bool same_cube(const exact::Vector &a, const exact::Vector &b) const { return axis_.cube_at(a) == axis_.cube_at(b); }

 private:
  // How many bits the numbers below `count` have.
  static uint32_t bits_below(uint64_t count) {
    return count < 2 ? 0 : static_cast<uint32_t>(std::bit_width(count - 1));
  }

  CubeAxis axis_;
  CubeCoordinates first_;
  uint64_t count_x_, count_y_, count_z_;  // of cubes
  double slices_per_step_;
  uint32_t slice_bits_;
};

namespace grid_order_parts {

// The number of passes that sort_by() makes.
[[gnu::noinline]] inline uint32_t passes_for(const DigitSort &sort, uint32_t bits) {
  uint32_t passes = 0;
  for (uint32_t shift = 0; shift < bits || shift == 0; shift += 32) {
    passes += sort.passes_for(bits - shift < 32 ? bits - shift : 32).count;
  }
  return passes;
}

// Fills entries first .. last - 1, and counts each value of their first digit. first_time: the balls are in the order
// of their numbers. A call of its own, so that this loop has the registers.
template <class Source, class Key>
HSP_APART_UNLESS_SMALL void fill_entries(const DigitSort &sort, const Source source, bool first_time, uint32_t shift,
                                         const Key key, uint32_t first, uint32_t last) {
  const Span<uint32_t> entries = sort.entries(), counts = sort.key_counts();
  const uint32_t first_shift = sort.first_shift(), mask = sort.mask();
  for (uint32_t k = first; k < last; ++k) {
    const uint32_t ball = first_time ? k : entries[2 * k + 1];
    const uint32_t part = static_cast<uint32_t>(key(source.centre(ball)) >> shift);
    entries[2 * k] = part;
    entries[2 * k + 1] = ball;
    ++counts[(part >> first_shift) & mask];
  }
}

// Sorts by so many bits of a key above its lowest `others`, 32 of them at a time.
template <class Source, class Key>
void sort_by(DigitSort &sort, const Source &source, bool first_time, uint32_t bits, const Key &key, Patience &patience,
             uint32_t others = 0) {
  for (uint32_t shift = 0; shift < bits || shift == 0; shift += 32) {
    sort.begin(bits - shift < 32 ? bits - shift : 32, others);
    const uint32_t n = sort.entries().size() / 2;
    for (uint32_t first = 0, last = 0; last < n; first = last) {
      constexpr uint32_t at_once = 1 << 16;
      if (!patience.allows(100 * at_once)) return;
      last = n - first < at_once ? n : first + at_once;
      fill_entries(sort, source, first_time, shift, key, first, last);
    }
    sort.sort(patience);
    first_time = false;
  }
}

// With so many bits for slices few balls are left whose order must be found by comparing.
inline constexpr uint32_t enough_slice_bits = 4;
// Sorts entries of one slice that are not in the order of their keys, each by exchanges with entries before it. There
// are at most most_exchanges for one entry: a slice with very many balls is left to sort_slice().
inline constexpr uint32_t most_exchanges = 8;
inline void sort_in_slices(Span<uint32_t> entries) {
  uint32_t *const entry = entries.data();
  for (size_t k = 2; k < entries.size(); k += 2) {
    if (entry[k - 2] <= entry[k]) [[likely]]
      continue;
    const uint32_t key = entry[k], ball = entry[k + 1];
    const size_t least = k > 2 * most_exchanges ? k - 2 * most_exchanges : 0;
    size_t to = k;
    for (; to > least && entry[to - 2] > key; to -= 2) {
      entry[to] = entry[to - 2];
      entry[to + 1] = entry[to - 1];
    }
    entry[to] = key;
    entry[to + 1] = ball;
  }
}

// Sorts the entries of one slice by rank. All get the key of the first. Few balls get here: as cold code it takes a
// fifth of the code size.
template <class Source>
[[gnu::cold, gnu::noinline]] void sort_by_rank(const Source &source, Span<uint32_t> entries) {
  const uint32_t n = entries.size() / 2;
  const uint32_t key = entries[0];
  for (uint32_t k = 0; k < n; ++k) entries[k] = entries[2 * k + 1];
  sort_in_place(entries.part(0, n),
                [&source](uint32_t a, uint32_t b) { return exact::ranks_before(source.ball(a), source.ball(b)); });
  for (uint32_t k = n; k-- > 0;) {
    entries[2 * k + 1] = entries[k];
    entries[2 * k] = key;
  }
}

// The run of consecutive entries around number k for which alike(entry, neighbouring entry) holds.
template <class Alike>
BallRange run_around(uint32_t k, uint32_t n, const Alike &alike) {
  BallRange run{k, k + 1};
  while (run.first > 0 && alike(run.first - 1, k)) --run.first;
  while (run.last < n && alike(run.last, k)) ++run.last;
  return run;
}

// For boxes of 2^40 cubes or more: sorts by the numbers along each axis, first by x, then by y, then by z.
template <class Source>
[[gnu::cold, gnu::noinline]] void sort_by_axes(DigitSort &sort, const Source &source, const CubeNumbers &numbers,
                                               Patience &patience) {
  const uint32_t bits[] = {numbers.bits_x(), numbers.bits_y(), numbers.bits_z()};
  const uint32_t passes = passes_for(sort, bits[0]) + passes_for(sort, bits[1]) + passes_for(sort, bits[2]);
  if (passes % 2 != 0) sort.exchange();
  for (int axis = 0; axis < 3; ++axis) {
    const auto along = [&, axis](const exact::Vector &centre) { return numbers.along(axis, centre); };
    sort_by(sort, source, axis == 0, bits[axis], along, patience);
  }
}

// If keys do not tell cubes: sorts the balls of those cubes in which they are not in order.
template <class Source>
[[gnu::cold, gnu::noinline]] void sort_cubes_by_rank(const Source &source, const CubeNumbers &numbers,
                                                     const GridOrder &order) {
  const auto same_cube = [&](uint32_t k, uint32_t l) {
    return order.same_slice(k, l) && numbers.same_cube(source.centre(order.ball(k)), source.centre(order.ball(l)));
  };
  for (uint32_t k = 1; k < order.size(); ++k) {
    if (!same_cube(k - 1, k) || source.centre(order.ball(k - 1)).x < source.centre(order.ball(k)).x) continue;
    const BallRange run = run_around(k, order.size(), same_cube);
    sort_by_rank(source, order.entries.part(2 * run.first, 2 * run.last));
    k = run.last;
  }
}

}  // namespace grid_order_parts

// Sorts the entries in the slice of entry k by rank. Returns which entries these are.
template <class Source>
BallRange sort_slice(const Source &source, const GridOrder &order, uint32_t k) {
  const auto same_slice = [&](uint32_t i, uint32_t j) { return order.same_slice(i, j); };
  const BallRange run = grid_order_parts::run_around(k, order.size(), same_slice);
  grid_order_parts::sort_by_rank(source, order.entries.part(2 * run.first, 2 * run.last));
  return run;
}

// The grid order of the balls of a source. box: the box around their centres. The number of balls is that for which
// scratch.entries has room. O(n) if no more than a bounded number of balls lie in one cube. If `patience` allows no
// more work, the result is no order.
template <class Source>
GridOrder grid_order(const Source &source, const LatticeBox &box, const CubeAxis &axis, const GridOrderScratch &scratch,
                     Patience &patience) {
  using namespace grid_order_parts;
  DigitSort sort(scratch.entries, scratch.other_entries, scratch.counters);
  GridOrder order{scratch.entries, false, 0, 0};
  if (order.size() == 0) return order;
  CubeNumbers numbers(box, axis);
  if (numbers.cubes() < 0x1p40) {
    const uint32_t bits = numbers.bits();
    const uint32_t sorted = sort.passes_for(bits + enough_slice_bits).all_bits();
    order.keys_tell_cubes = sorted <= 32;
    order.bits_in_slice = order.keys_tell_cubes ? 32 - sorted : 0;
    order.slice_bits = sorted + order.bits_in_slice - bits;
    numbers.slice(order.slice_bits);
    if (passes_for(sort, sorted) % 2 != 0) sort.exchange();
    sort_by(sort, source, true, sorted, numbers, patience, order.bits_in_slice);
    if (!patience.allows(10 * uint64_t{order.size()})) return order;
    if (order.keys_tell_cubes) sort_in_slices(order.entries);
  } else {
    sort_by_axes(sort, source, numbers, patience);
    if (!patience.allows(0)) return order;
  }
  if (!order.keys_tell_cubes) sort_cubes_by_rank(source, numbers, order);
  return order;
}

// The same by comparing balls, without keys, in less code: O(n log n). entries [2 n].
inline GridOrder grid_order_by_comparing(const BallSet &balls, const CubeAxis &axis, Span<uint32_t> entries) {
  const Span<uint32_t> order = entries.part(0, balls.n);
  for (uint32_t k = 0; k < balls.n; ++k) order[k] = k;
  sort_in_place(order, [&](uint32_t i, uint32_t j) {
    for (const Span<double> *coordinate : {&balls.z, &balls.y, &balls.x}) {
      const int64_t a = axis.cube_at(static_cast<int64_t>((*coordinate)[i]));
      const int64_t b = axis.cube_at(static_cast<int64_t>((*coordinate)[j]));
      if (a != b) return a < b;
    }
    return balls.ranks_before(i, j);
  });
  for (uint32_t k = balls.n; k-- > 0;) entries[2 * k + 1] = entries[k];
  return {entries, false, 0, 0};
}

}  // namespace hsp
