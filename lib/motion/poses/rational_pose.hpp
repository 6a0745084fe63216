// A rigid motion without any rounding: x goes to M x / N + t, with M the integer matrix of a quaternion of integers, N
// the square of the quaternion's length, and t a lattice point. The squared distances of moved centres are fractions
// over N^2, so that integers of 256 bits decide which balls meet.
//
// With centres and t up to 2^50 steps, entries of M and N are at most 2^64, components of N (c - t) - M p below 2^117,
// and the sum of their squares below 2^236. N^2 (r + s)^2 is at most 2^190.
#pragma once

#include "exact/wide_integer.hpp"
#include "poses/pose.hpp"

namespace hsp {

class RationalPose {
 public:
  // The pose at rest.
  RationalPose() = default;

  // quaternion: w, x, y, z, not all 0; translation: lengths, which are rounded to the lattice. Status as Pose::make.
  static Status make(const int32_t *quaternion, const double *translation, const exact::Lattice &lattice,
                     RationalPose &pose);

  // The image of a point in doubles, in steps.
  Vec3 image(const Vec3 &p) const { return rounded_.image(p); }
  const Pose &rounded() const { return rounded_; }
  bool has_room_for(double reach) const { return rounded_.has_room_for(reach); }
  // A bound of the rounding of such an image of a point within `reach` of the origin, and of distances of such images
  // from lattice points within it. Entries of the rounded matrix are off by at most 17 units of 2^-53, so that images
  // are off by at most 63 units times the reach and 2 units times the shift.
  double slack(double reach) const { return 0x1p-46 * (reach + rounded_.largest_shift()); }

  // Whether a ball about the lattice point c and one about the image of p meet, by integers alone. sum: of their radii.
  bool meet_exactly(const Vec3 &c, const Vec3 &p, double sum) const;
  // The distance from c to the image of p, in steps; its relative error is below 2^-51.
  double distance(const Vec3 &c, const Vec3 &p) const;

 private:
  template <int bits>
  using Integer = exact::WideInteger<exact::FastLimb, bits>;

  // The square of N times the distance.
  Integer<256> scaled_square(const Vec3 &c, const Vec3 &p) const;

  Pose rounded_;
  Integer<128> matrix_[3][3] = {
      {Integer<128>::from(1), {}, {}}, {{}, Integer<128>::from(1), {}}, {{}, {}, Integer<128>::from(1)}};
  Integer<128> scale_ = Integer<128>::from(1);  // N
  int64_t shift_[3] = {0, 0, 0};
};

}  // namespace hsp
