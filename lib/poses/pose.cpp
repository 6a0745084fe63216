#include "poses/pose.hpp"

namespace hsp {

Status Pose::make(const double *quaternion, const double *translation, const exact::Lattice &lattice, Pose &pose) {
  for (int k = 0; k < 4; ++k)
    if (!is_finite(quaternion[k])) return Status::not_finite;
  for (int k = 0; k < 3; ++k)
    if (!is_finite(translation[k])) return Status::not_finite;
  double largest = 0;
  for (int k = 0; k < 4; ++k)
    if (std::fabs(quaternion[k]) > largest) largest = std::fabs(quaternion[k]);
  if (!(largest >= 0x1p-300 && largest <= 0x1p300)) return Status::range;
  const double w = quaternion[0], x = quaternion[1], y = quaternion[2], z = quaternion[3];
  const double s = 2.0 / ((w * w + x * x) + (y * y + z * z));
  const Vec3 steps{lattice.steps(translation[0]), lattice.steps(translation[1]), lattice.steps(translation[2])};
  const auto is_on_lattice = [](double shift) { return std::fabs(shift) <= exact::coordinate_limit; };
  if (!is_on_lattice(steps.x) || !is_on_lattice(steps.y) || !is_on_lattice(steps.z)) return Status::range;
  pose.row_[0] = {1.0 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)};
  pose.row_[1] = {s * (x * y + w * z), 1.0 - s * (x * x + z * z), s * (y * z - w * x)};
  pose.row_[2] = {s * (x * z - w * y), s * (y * z + w * x), 1.0 - s * (x * x + y * y)};
  pose.translation_ = steps;
  return Status::ok;
}

}  // namespace hsp
