// A rigid motion of a molecule: x goes to R x + t, R the rotation of a quaternion.
//
// Moved centres are snapped: they go to the lattice point nearest to their image, which is computed in doubles. For
// coordinates below 2^40 steps that point is within 0.87 steps of the exact image. So a decision of integers about two
// snapped balls holds for the exact images, too, if the gap between the two balls is more than a step from 0. A pose
// gives the same snapped balls on every machine.
#pragma once

#include "core/status.hpp"
#include "core/vec3.hpp"
#include "exact/lattice.hpp"
#include "lanes/floating_point.hpp"

namespace hsp {

// The lattice point nearest to a point in steps.
inline Vec3 snapped(const Vec3 &p) {
  return {static_cast<double>(nearest(p.x)), static_cast<double>(nearest(p.y)), static_cast<double>(nearest(p.z))};
}

class Pose {
 public:
  // The pose at rest.
  Pose() = default;

  // quaternion: w, x, y, z, of any length but 0; translation: lengths. Status::not_finite for numbers that are not
  // finite, Status::range for a quaternion of length 0 or beyond 2^-300 to 2^300, or a translation beyond the lattice.
  static Status make(const double *quaternion, const double *translation, const exact::Lattice &lattice, Pose &pose);

  // The image of a point, in steps, not rounded to the lattice.
  Vec3 image(const Vec3 &p) const {
    return {(row_[0].x * p.x + row_[0].y * p.y + row_[0].z * p.z) + translation_.x,
            (row_[1].x * p.x + row_[1].y * p.y + row_[1].z * p.z) + translation_.y,
            (row_[2].x * p.x + row_[2].y * p.y + row_[2].z * p.z) + translation_.z};
  }
  // The lattice point nearest to the image of a point, which is within a `reach` of the origin that has_room_for
  // accepts.
  Vec3 snapped(const Vec3 &p) const { return hsp::snapped(image(p)); }
  // Whether images of points within `reach` of the origin are on the lattice. Then differences between their
  // coordinates and those of other lattice points are exact in doubles.
  bool has_room_for(double reach) const { return reach + largest_shift() <= exact::query_radius_limit; }
  // More than the distance of a snapped point from its exact image, plus the rounding of distances of such points.
  double slack(double reach) const { return 1.0 + 0x1p-48 * (reach + largest_shift()); }

  double largest_shift() const {
    return std::fabs(translation_.x) + std::fabs(translation_.y) + std::fabs(translation_.z);
  }
  // A row of the rotation's matrix.
  const Vec3 &row(uint32_t k) const { return row_[k]; }
  // Rounds the translation to the lattice, and returns it.
  Vec3 snap_translation() {
    translation_ = hsp::snapped(translation_);
    return translation_;
  }

 private:
  Vec3 row_[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Vec3 translation_{0, 0, 0};  // steps
};

// The quaternion (w, x, y, z), of length 1 up to 1e-6, of the rotation nearest to a matrix [3][3] whose rows are
// orthonormal up to 1e-6. Status::not_finite or Status::range for other matrices.
Status quaternion_of_rotation(const double *matrix, double *quaternion);

}  // namespace hsp
