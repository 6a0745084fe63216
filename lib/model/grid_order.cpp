#include "model/grid_order.hpp"

#include <initializer_list>

#include "core/small_code.hpp"
#include "core/sorting.hpp"

namespace hsp {
namespace {

// Sorts by digits, the lowest first (Knuth, TAOCP 3, section 5.2.5, algorithm R): each pass is a stable counting sort.
class DigitSort {
 public:
  DigitSort(uint32_t n, const GridOrderScratch &scratch)
      : order_(scratch.order.part(0, n)),
        other_(scratch.other_order.part(0, n)),
        digits_(scratch.digits.part(0, n)),
        counters_(scratch.counters) {
    while (bits_ < most_bits && UINT32_C(2) << bits_ <= counters_.size()) ++bits_;
    for (uint32_t k = 0; k < n; ++k) order_[k] = k;
  }

  // The number of values that one pass tells apart.
  uint64_t values() const { return UINT64_C(1) << bits_; }

  template <class Key>
  void by(const Key &key) {
    for (uint32_t shift = 0; shift < 64 && (key.largest() >> shift) != 0; shift += bits_) pass(shift, key);
  }

  Span<uint32_t> order() const { return order_; }

 private:
  template <class Key>
  void pass(uint32_t shift, const Key &key) {
    const uint32_t n = order_.size();
    const uint64_t mask = values() - 1;
    for (uint32_t value = 0; value <= mask; ++value) counters_[value] = 0;
    for (uint32_t k = 0; k < n; ++k) {
      const uint32_t digit = static_cast<uint32_t>((key(order_[k]) >> shift) & mask);
      digits_[k] = digit;
      ++counters_[digit];
    }
    uint32_t place = 0;
    for (uint32_t value = 0; value <= mask; ++value) {
      const uint32_t count = counters_[value];
      counters_[value] = place;
      place += count;
    }
    for (uint32_t k = 0; k < n; ++k) other_[counters_[digits_[k]]++] = order_[k];
    const Span<uint32_t> sorted = other_;
    other_ = order_;
    order_ = sorted;
  }

  static constexpr uint32_t most_bits = 11;  // more counters than fit the nearest memory cost more than a further pass
  Span<uint32_t> order_, other_, digits_, counters_;
  uint32_t bits_ = 0;
};

// The places of the balls along one axis: their cubes, each cut into slices of equal width.
class Places {
 public:
  // At most that many places, if there are no more cubes.
  Places(const BallSet &balls, const Span<double> &coordinate, const CubeAxis &axis, uint64_t most)
      : coordinate_(coordinate), axis_(axis) {
    double low = coordinate[0], high = coordinate[0];
    for (uint32_t i = 1; i < balls.n; ++i) {
      const double value = coordinate[i];
      low = value < low ? value : low;
      high = value > high ? value : high;
    }
    first_cube_ = axis.cube_at(static_cast<int64_t>(low));
    const uint64_t cubes = static_cast<uint64_t>(axis.cube_at(static_cast<int64_t>(high)) - first_cube_) + 1;
    while (cubes << (slice_bits_ + 1) <= most) ++slice_bits_;
    slices_per_step_ = static_cast<double>(INT64_C(1) << slice_bits_) / static_cast<double>(axis.side());
    largest_ = (cubes << slice_bits_) - 1;
  }

  uint64_t largest() const { return largest_; }
  // Of ball i, from 0 to largest(); ascending with the coordinate. The quotient is below the number of slices by at
  // least 1 / side, so that rounding does not reach it.
  uint64_t operator()(uint32_t i) const {
    const int64_t value = static_cast<int64_t>(coordinate_[i]);
    const int64_t cube = axis_.cube_at(value);
    const double inside = static_cast<double>(value - cube * axis_.side());
    return (static_cast<uint64_t>(cube - first_cube_) << slice_bits_) +
           static_cast<uint64_t>(static_cast<int64_t>(inside * slices_per_step_));
  }

 private:
  const Span<double> &coordinate_;
  const CubeAxis &axis_;
  int64_t first_cube_;
  uint64_t largest_;
  double slices_per_step_;
  uint32_t slice_bits_ = 0;
};

}  // namespace

Span<uint32_t> grid_order(const BallSet &balls, const CubeAxis &axis, const GridOrderScratch &scratch) {
  if (small_code) return grid_order_by_comparing(balls, axis, scratch.order.part(0, balls.n));
  DigitSort sort(balls.n, scratch);
  if (balls.n == 0) return sort.order();
  // Along x the digit has room for slices, so that few balls are left to be compared with each other.
  const Places places[] = {{balls, balls.x, axis, sort.values()}, {balls, balls.y, axis, 0}, {balls, balls.z, axis, 0}};
  for (const Places &along_axis : places) sort.by(along_axis);

  const Span<uint32_t> order = sort.order();
  const auto same_place = [&places](uint32_t i, uint32_t j) {
    for (const Places &along_axis : places) {
      if (along_axis(i) != along_axis(j)) return false;
    }
    return true;
  };
  for (uint32_t k = 1; k < balls.n; ++k) {
    const uint32_t i = order[k];
    if (balls.x[order[k - 1]] < balls.x[i] || !same_place(order[k - 1], i)) continue;
    uint32_t first = k - 1;
    while (first > 0 && same_place(order[first - 1], i)) --first;
    while (k < balls.n && same_place(order[k], i)) ++k;
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
