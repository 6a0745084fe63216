// The order of the balls in the grid: by the z, the y and then the x of their cubes, and in one cube by rank. So the
// cubes of one row, with equal y and z, follow each other, and so do the balls of neighbouring cubes of a row: one
// search in the hash table finds all of them. The order depends on the balls alone, not on that of the input (but for
// balls that are equal), so that neither does anything that runs in the order of ids.
//
// Balls come from a source, which may compute them when they are asked for: source.centre(i) and source.ball(i) are
// ball i on the lattice.
//
// In a plane, six balls by letters in cubes of side 10, of which those of one cube are in the order of their ranks:
//       y |
//     10  |   D   E |       |   F
//      0  |   A   B |   C   |             order:  A B | C | D E | F      cubes (0,0) (1,0) (0,1) (2,1)
//         +---------------------- x
//             0        10      20
// The neighbours of C are in the cubes from (0,-1) to (2,1): of the row y = 0 they are A to C, of the row y = 10 D to
// F.
#pragma once

#include <bit>

#include "core/small_code.hpp"
#include "core/sorting.hpp"
#include "model/ball_range.hpp"
#include "model/ball_set.hpp"
#include "model/cube_list.hpp"
#include "model/digit_sort.hpp"

namespace hsp {

// The cubes of side `side`, along one axis.
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

// Scratch memory: two numbers per ball in each of the first two, and counters as a DigitSort needs. The order will be
// in the first.
struct GridOrderScratch {
  Span<uint32_t> entries, other_entries, counters;
};

// Balls in grid order, by their numbers in the source. Where keys tell cubes, balls of one slice may not be in order
// yet: few are not, and they are looked at when balls are read anyway.
struct GridOrder {
  Span<uint32_t> entries;  // [2 n] a key and a ball each
  bool keys_tell_cubes;    // whether balls are in one cube if and only if their keys are, but for the lowest bits
  uint32_t slice_bits;     // how many
  uint32_t bits_in_slice;  // of these, in which keys of one slice differ

  uint32_t size() const { return entries.size() / 2; }
  uint32_t ball(uint32_t k) const { return entries[2 * k + 1]; }
  uint32_t key(uint32_t k) const { return entries[2 * k]; }
  uint64_t cube_key(uint32_t k) const { return uint64_t{key(k)} >> slice_bits; }
  bool same_slice(uint32_t k, uint32_t l) const { return (key(k) ^ key(l)) >> bits_in_slice == 0; }
};

// Numbers of the cubes of a box, in the order of the grid, each cut into slices of equal width along x; and of the
// cubes along each axis, from 0 on.
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

  // Of cubes: at least that many.
  double cubes() const {
    return static_cast<double>(count_x_) * static_cast<double>(count_y_) * static_cast<double>(count_z_);
  }
  // Of all numbers, if there are no more than 2^64 of them; and of those along each axis.
  uint32_t bits() const { return bits_below((count_x_ * count_y_ * count_z_) << slice_bits_); }
  uint32_t bits_x() const { return bits_below(count_x_); }
  uint32_t bits_y() const { return bits_below(count_y_); }
  uint32_t bits_z() const { return bits_below(count_z_); }

  // That of a centre, and its slice: the quotient is below the number of slices by at least 1 / side, so that rounding
  // does not reach it.
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

// Passes of sort_by().
[[gnu::noinline]] inline uint32_t passes_for(const DigitSort &sort, uint32_t bits) {
  uint32_t passes = 0;
  for (uint32_t shift = 0; shift < bits || shift == 0; shift += 32) {
    passes += sort.passes_for(bits - shift < 32 ? bits - shift : 32).count;
  }
  return passes;
}

// Entries first .. last - 1, and how often each value of their first digit is there. A call, so that this loop has its
// registers. The first time the balls are in the order of their numbers.
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

// So many slices of a cube leave few balls whose order is left to compare.
inline constexpr uint32_t enough_slice_bits = 4;
// Entries of one slice that are not in the order of their keys, each by exchanges with those before it. That is so many
// of them at most: a slice of a cube with very many balls is left to sort_slice().
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

// Entries of one slice: by rank. All get the key of the first. Few balls get here: cold, it takes a fifth of the code.
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

// The entries around number k that are `alike`, which are one behind the other.
template <class Alike>
BallRange run_around(uint32_t k, uint32_t n, const Alike &alike) {
  BallRange run{k, k + 1};
  while (run.first > 0 && alike(run.first - 1, k)) --run.first;
  while (run.last < n && alike(run.last, k)) ++run.last;
  return run;
}

// Where cubes have no numbers of 40 bits: by the cubes along each axis, the last one first.
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

// Where keys do not tell cubes: balls of one cube that are not in order.
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

// Brings the entries in the slice of number k into the order of rank; returns which these are.
template <class Source>
BallRange sort_slice(const Source &source, const GridOrder &order, uint32_t k) {
  const auto same_slice = [&](uint32_t i, uint32_t j) { return order.same_slice(i, j); };
  const BallRange run = grid_order_parts::run_around(k, order.size(), same_slice);
  grid_order_parts::sort_by_rank(source, order.entries.part(2 * run.first, 2 * run.last));
  return run;
}

// The order of the balls of the source in the box around them, as many as there is scratch memory for. O(n) if no more
// than a bounded number of balls lie in one cube. No order if that is no longer allowed.
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

// The same in less code, without keys: O(n log n). entries [2 n].
GridOrder grid_order_by_comparing(const BallSet &balls, const CubeAxis &axis, Span<uint32_t> entries);

}  // namespace hsp
