#include "periodic/periodic_box.hpp"

namespace hsp {
namespace {

exact::Vector less(const exact::Vector &v, int64_t times, const exact::Vector &w) {
  return {v.x - times * w.x, v.y - times * w.y, v.z - times * w.z};
}

bool is_at_most(int64_t value, int64_t limit) {
  return value <= limit && -value <= limit;
}

}  // namespace

Status PeriodicBox::set(const exact::Lattice &lattice, const double vector[9]) {
  for (int k = 0; k < 9; ++k) {
    if (!is_finite(vector[k])) return Status::not_finite;
  }
  BoxFrame frame;
  if (!frame.set(vector)) return Status::range;
  exact::Vector wanted[3];
  for (int row = 0; row < 3; ++row) {
    const Vec3 turned = frame.turned_in(vector + 3 * row);
    const double steps[3] = {lattice.steps(turned.x), lattice.steps(turned.y), lattice.steps(turned.z)};
    for (const double length : steps) {
      if (!(std::fabs(length) <= longest)) return Status::range;
    }
    // A turned vector is off its axis or plane by much less than half a step.
    wanted[row] = {nearest(steps[0]), nearest(steps[1]), nearest(steps[2])};
  }
  const int64_t along[3] = {wanted[0].x, wanted[1].y, wanted[2].z};
  exact::Vector upright[3];
  for (int row = 0; row < 3; ++row) {
    if (along[row] == 0) return Status::range;
    upright[row] = along[row] < 0 ? less({0, 0, 0}, 1, wanted[row]) : wanted[row];
  }
  auto [a, b, c] = upright;
  // The multiple of `whole` that is nearest to a length.
  const auto nearest_multiple = [](int64_t length, int64_t whole) {
    return floored_quotient(2 * length + whole, 2 * whole);
  };
  int64_t skew[3];
  skew[0] = nearest_multiple(b.x, a.x);
  skew[1] = nearest_multiple(c.y, b.y);
  if (!is_at_most(skew[0], largest_skew) || !is_at_most(skew[1], largest_skew)) return Status::range;
  b = less(b, skew[0], a);
  c = less(c, skew[1], b);
  skew[2] = nearest_multiple(c.x, a.x);
  if (!is_at_most(skew[2], largest_skew)) return Status::range;
  c = less(c, skew[2], a);

  for (int row = 0; row < 3; ++row) {
    given_[row] = wanted[row];
    skew_[row] = static_cast<int32_t>(skew[row]);
    side_[row] = along[row] < 0 ? -1 : 1;
  }
  frame_ = frame;
  reduced_[0] = a;
  reduced_[1] = b;
  reduced_[2] = c;
  return Status::ok;
}

bool PeriodicBox::suits(int64_t largest_radius) const {
  constexpr int64_t most = 4 * largest_shift / 9 - 1;
  const auto &[a, b, c] = reduced_;
  const auto is_long = [&](int64_t side) { return 2 * largest_radius <= most * side; };
  return is_long(a.x) && is_long(b.y) && is_long(c.z);
}

Status PeriodicBox::wrap_outside(exact::Vector &point, BoxShift &shift) const {
  const auto &[a, b, c] = reduced_;
  exact::Vector p = point;
  int64_t times[3];
  times[2] = floored_quotient(p.z, c.z);
  if (!is_at_most(times[2], farthest_copy)) return Status::range;
  p = less(p, times[2], c);
  times[1] = floored_quotient(p.y, b.y);
  if (!is_at_most(times[1], farthest_copy)) return Status::range;
  p = less(p, times[1], b);
  times[0] = floored_quotient(p.x, a.x);
  if (!is_at_most(times[0], farthest_copy)) return Status::range;
  point = less(p, times[0], a);
  for (int axis = 0; axis < 3; ++axis) shift.k[axis] = static_cast<int32_t>(times[axis]);
  return Status::ok;
}

exact::Vector PeriodicBox::translation(const BoxShift &shift) const {
  exact::Vector sum{0, 0, 0};
  for (int axis = 0; axis < 3; ++axis) sum = less(sum, -int64_t{shift.k[axis]}, reduced_[axis]);
  return sum;
}

BoxShift PeriodicBox::centre(Vec3 &difference) const {
  const Vec3 a = to_double(reduced_[0]), b = to_double(reduced_[1]), c = to_double(reduced_[2]);
  BoxShift shift;
  const auto less = [&](int axis, double multiple, const Vec3 &side) {
    shift.k[axis] = static_cast<int32_t>(nearest(multiple));
    difference = difference - static_cast<double>(shift.k[axis]) * side;
  };
  less(2, difference.z / c.z, c);
  less(1, difference.y / b.y, b);
  less(0, difference.x / a.x, a);
  return shift;
}

// By b = B - p A and c = C - q b - r A, where A, B, C are the given vectors, or reversed ones.
BoxShift PeriodicBox::in_given_vectors(const BoxShift &shift) const {
  const auto [p, q, r] = skew_;
  const auto [i, j, k] = shift.k;
  return {{side_[0] * (i - p * j + (q * p - r) * k), side_[1] * (j - q * k), side_[2] * k}};
}

}  // namespace hsp
