// A rigid motion without any rounding: x goes to M x / N + t, M the integer matrix of a quaternion of integers, N the
// square of its length, t a lattice point. Distances of moved balls are irrational numbers whose squares are fractions
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
  // At rest.
  RationalPose() = default;

  // quaternion: w, x, y, z, not all 0; translation: lengths, which are rounded to the lattice. Status as Pose::make.
  static Status make(const int32_t *quaternion, const double *translation, const exact::Lattice &lattice,
                     RationalPose &pose);

  // Somewhat rounded, in steps.
  Vec3 image(const Vec3 &p) const { return rounded_.image(p); }
  const Pose &rounded() const { return rounded_; }
  bool has_room_for(double reach) const { return rounded_.has_room_for(reach); }
  // More than the length of what such an image of a point within `reach` of the origin, and distances of such images
  // from lattice points within it, are rounded by: entries of the rounded matrix are off by at most 17 units of 2^-53,
  // so that images are by at most 63 of them times the reach and 2 times the shift.
  double slack(double reach) const { return 0x1p-46 * (reach + rounded_.largest_shift()); }

  // Whether a ball about the lattice point c and one about the image of p meet, for the sum of their radii, by integers
  // alone.
  bool meet_exactly(const Vec3 &c, const Vec3 &p, double sum) const;
  // From c to the image of p, in steps; its relative error is below 2^-51.
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
