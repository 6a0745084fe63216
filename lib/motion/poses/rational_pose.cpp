#include "poses/rational_pose.hpp"

namespace hsp {

using exact::product;

Status RationalPose::make(const int32_t *quaternion, const double *translation, const exact::Lattice &lattice,
                          RationalPose &pose) {
  double numbers[4];
  for (int k = 0; k < 4; ++k) numbers[k] = quaternion[k];
  const Status status = Pose::make(numbers, translation, lattice, pose.rounded_);
  if (status != Status::ok) return status;
  const Vec3 shift = pose.rounded_.snap_translation();
  pose.shift_[0] = static_cast<int64_t>(shift.x);
  pose.shift_[1] = static_cast<int64_t>(shift.y);
  pose.shift_[2] = static_cast<int64_t>(shift.z);
  // Products of two components, at most 2^62.
  const int64_t w = quaternion[0], x = quaternion[1], y = quaternion[2], z = quaternion[3];
  const auto integer = [](int64_t value) { return Integer<128>::from(value); };
  const auto twice = [&](int64_t a, int64_t b) {
    const Integer<128> sum = integer(a) + integer(b);
    return sum + sum;
  };
  const Integer<128> ww = integer(w * w), xx = integer(x * x), yy = integer(y * y), zz = integer(z * z);
  pose.scale_ = (ww + xx) + (yy + zz);
  pose.matrix_[0][0] = (ww + xx) - (yy + zz);
  pose.matrix_[1][1] = (ww + yy) - (xx + zz);
  pose.matrix_[2][2] = (ww + zz) - (xx + yy);
  pose.matrix_[0][1] = twice(x * y, -(w * z));
  pose.matrix_[1][0] = twice(x * y, w * z);
  pose.matrix_[0][2] = twice(x * z, w * y);
  pose.matrix_[2][0] = twice(x * z, -(w * y));
  pose.matrix_[1][2] = twice(y * z, -(w * x));
  pose.matrix_[2][1] = twice(y * z, w * x);
  return Status::ok;
}

RationalPose::Integer<256> RationalPose::scaled_square(const Vec3 &c, const Vec3 &p) const {
  const auto integer = [](double value) { return Integer<64>::from(static_cast<int64_t>(value)); };
  const Integer<64> from[3] = {integer(p.x), integer(p.y), integer(p.z)};
  const double to[3] = {c.x, c.y, c.z};
  Integer<256> sum{};
  for (int k = 0; k < 3; ++k) {
    const Integer<64> difference = Integer<64>::from(static_cast<int64_t>(to[k]) - shift_[k]);
    Integer<128> component = product<128>(scale_, difference);
    for (int j = 0; j < 3; ++j) component = component - product<128>(matrix_[k][j], from[j]);
    sum = sum + product<256>(component, component);
  }
  return sum;
}

bool RationalPose::meet_exactly(const Vec3 &c, const Vec3 &p, double sum) const {
  const Integer<128> within = product<128>(scale_, Integer<64>::from(static_cast<int64_t>(sum)));
  return (scaled_square(c, p) - product<256>(within, within)).sign() <= 0;
}

double RationalPose::distance(const Vec3 &c, const Vec3 &p) const {
  return std::sqrt(scaled_square(c, p).to_double()) / scale_.to_double();
}

}  // namespace hsp
