#include "model/grid_order.hpp"

#include <bit>
#include <initializer_list>

#include "core/small_code.hpp"
#include "core/sorting.hpp"

namespace hsp {
namespace {

// Sorts by digits, the lowest first (Knuth, TAOCP 3, section 5.2.5, algorithm R): each pass is a stable counting sort.
// The keys move along with the balls, so that only the places where a pass writes are far from each other.
class DigitSort {
 public:
  DigitSort(uint32_t n, const GridOrderScratch &scratch)
      : order_(scratch.order.part(0, n)),
        other_order_(scratch.other_order.part(0, n)),
        keys_(scratch.keys.part(0, n)),
        other_keys_(scratch.other_keys.part(0, n)),
        counters_(scratch.counters) {
    while (most_bits_ < 11 && UINT32_C(2) << most_bits_ <= counters_.size()) ++most_bits_;
    for (uint32_t k = 0; k < n; ++k) order_[k] = k;
  }

  // Passes that tell so many bits apart, in equal parts: two short ones cost less than a short and a long one, whose
  // counters and destinations do not fit the nearest memory.
  struct Passes {
    uint32_t count, bits;
    uint32_t all_bits() const { return count * bits; }
  };
  Passes passes_for(uint32_t bits) const {
    const uint32_t count = bits == 0 ? 1 : (bits + most_bits_ - 1) / most_bits_;
    return {count, (bits + count - 1) / count};
  }

  template <class Key>
  void by(const Key &key) {
    for (uint32_t shift = 0; shift < key.bits() || shift == 0; shift += 32) {
      for (uint32_t k = 0; k < keys_.size(); ++k) keys_[k] = static_cast<uint32_t>(key(order_[k]) >> shift);
      const uint32_t bits = key.bits() - shift;
      const Passes passes = passes_for(bits < 32 ? bits : 32);
      for (uint32_t p = 0; p < passes.count; ++p) pass(p * passes.bits, passes.bits);
    }
  }

  Span<uint32_t> order() const { return order_; }
  // By which the balls were sorted last, in that order.
  const Span<uint32_t> &keys() const { return keys_; }

 private:
  void pass(uint32_t shift, uint32_t bits) {
    const uint32_t n = order_.size();
    const uint32_t mask = (UINT32_C(1) << bits) - 1;
    for (uint32_t value = 0; value <= mask; ++value) counters_[value] = 0;
    for (uint32_t k = 0; k < n; ++k) ++counters_[(keys_[k] >> shift) & mask];
    uint32_t place = 0;
    for (uint32_t value = 0; value <= mask; ++value) {
      const uint32_t count = counters_[value];
      counters_[value] = place;
      place += count;
    }
    for (uint32_t k = 0; k < n; ++k) {
      const uint32_t to = counters_[(keys_[k] >> shift) & mask]++;
      other_keys_[to] = keys_[k];
      other_order_[to] = order_[k];
    }
    exchange(order_, other_order_);
    exchange(keys_, other_keys_);
  }
  static void exchange(Span<uint32_t> &a, Span<uint32_t> &b) {
    const Span<uint32_t> first = a;
    a = b;
    b = first;
  }

  Span<uint32_t> order_, other_order_, keys_, other_keys_, counters_;
  uint32_t most_bits_ = 0;
};

// The cubes of the balls along one axis, from 0 on, each cut into slices of equal width.
class Places {
 public:
  Places(const BallSet &balls, const Span<double> &coordinate, const CubeAxis &axis)
      : coordinate_(coordinate), axis_(axis) {
    double low = coordinate[0], high = coordinate[0];
    for (uint32_t i = 1; i < balls.n; ++i) {
      const double value = coordinate[i];
      low = value < low ? value : low;
      high = value > high ? value : high;
    }
    first_cube_ = axis.cube_at(static_cast<int64_t>(low));
    count_ = static_cast<uint64_t>(axis.cube_at(static_cast<int64_t>(high)) - first_cube_) + 1;
    slice(0);
  }
  void slice(uint32_t bits) {
    slice_bits_ = bits;
    slices_per_step_ = static_cast<double>(UINT64_C(1) << bits) / static_cast<double>(axis_.side());
  }

  uint64_t count() const { return count_ << slice_bits_; }
  uint32_t bits() const { return bits_below(count()); }
  // Of ball i, below count(); ascending with the coordinate. The quotient is below the number of slices by at least
  // 1 / side, so that rounding does not reach it.
  uint64_t operator()(uint32_t i) const {
    const int64_t value = static_cast<int64_t>(coordinate_[i]);
    const int64_t cube = axis_.cube_at(value);
    const double inside = static_cast<double>(value - cube * axis_.side());
    return (static_cast<uint64_t>(cube - first_cube_) << slice_bits_) +
           static_cast<uint64_t>(static_cast<int64_t>(inside * slices_per_step_));
  }

  // How many bits the numbers below `count` have.
  static uint32_t bits_below(uint64_t count) {
    return count < 2 ? 0 : static_cast<uint32_t>(std::bit_width(count - 1));
  }

 private:
  const Span<double> &coordinate_;
  const CubeAxis &axis_;
  int64_t first_cube_;
  uint64_t count_;  // of cubes
  double slices_per_step_;
  uint32_t slice_bits_;
};

// The places along all axes as one number.
struct PlacesInSpace {
  Places x, y, z;

  // If the numbers have no more than 64 bits.
  uint32_t bits() const { return Places::bits_below(x.count() * y.count() * z.count()); }
  uint64_t operator()(uint32_t i) const { return (z(i) * y.count() + y(i)) * x.count() + x(i); }
  // At least.
  double count() const {
    return static_cast<double>(x.count()) * static_cast<double>(y.count()) * static_cast<double>(z.count());
  }
  bool same(uint32_t i, uint32_t j) const { return x(i) == x(j) && y(i) == y(j) && z(i) == z(j); }
};

// Balls of a large set are far from each other in the order of the grid. Those to be compared are on their way before.
constexpr uint32_t compared_balls_ahead = 16;

// So many slices of a cube leave few balls to be compared with each other.
constexpr uint32_t enough_slice_bits = 4;

}  // namespace

Span<uint32_t> grid_order(const BallSet &balls, const CubeAxis &axis, const GridOrderScratch &scratch) {
  if (small_code) return grid_order_by_comparing(balls, axis, scratch.order.part(0, balls.n));
  DigitSort sort(balls.n, scratch);
  if (balls.n == 0) return sort.order();
  PlacesInSpace places{{balls, balls.x, axis}, {balls, balls.y, axis}, {balls, balls.z, axis}};
  bool keys_are_places = false;
  if (places.count() < 0x1p40) {
    const uint32_t bits = places.bits();
    places.x.slice(sort.passes_for(bits + enough_slice_bits).all_bits() - bits);
    sort.by(places);
    keys_are_places = places.bits() <= 32;
  } else {
    sort.by(places.x);
    sort.by(places.y);
    sort.by(places.z);
  }

  const Span<uint32_t> order = sort.order();
  const Span<uint32_t> keys = sort.keys();
  // Balls are far from each other in memory, and asked only if need be.
  const auto same_place = [&](uint32_t k, uint32_t l) {
    return keys[k] == keys[l] && (keys_are_places || places.same(order[k], order[l]));
  };
  const auto fetch_if_same = [&](uint32_t k) {
    const bool same = keys[k - 1] == keys[k];
    __builtin_prefetch(&balls.x[order[same ? k - 1 : 0]]);
    __builtin_prefetch(&balls.x[order[same ? k : 0]]);
  };
  for (uint32_t k = 1; k < balls.n; ++k) {
    if (k + compared_balls_ahead < balls.n) fetch_if_same(k + compared_balls_ahead);
    if (!same_place(k - 1, k) || balls.x[order[k - 1]] < balls.x[order[k]]) continue;
    uint32_t first = k - 1;
    while (first > 0 && same_place(first - 1, k)) --first;
    while (k < balls.n && same_place(first, k)) ++k;
    sort_in_place(order.part(first, k), [&balls](uint32_t a, uint32_t b) { return balls.ranks_before(a, b); });
  }
  return order;
}

Span<uint32_t> grid_order_by_comparing(const BallSet &balls, const CubeAxis &axis, Span<uint32_t> order) {
  for (uint32_t k = 0; k < balls.n; ++k) order[k] = k;
  sort_in_place(order, [&](uint32_t i, uint32_t j) {
    for (const Span<double> *coordinate : {&balls.z, &balls.y, &balls.x}) {
      const int64_t a = axis.cube_at(static_cast<int64_t>((*coordinate)[i]));
      const int64_t b = axis.cube_at(static_cast<int64_t>((*coordinate)[j]));
      if (a != b) return a < b;
    }
    return balls.ranks_before(i, j);
  });
  return order;
}

}  // namespace hsp
