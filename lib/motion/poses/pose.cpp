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

Status quaternion_of_rotation(const double *matrix, double *quaternion) {
  for (int k = 0; k < 9; ++k)
    if (!is_finite(matrix[k])) return Status::not_finite;
  const Vec3 row[3] = {
      {matrix[0], matrix[1], matrix[2]}, {matrix[3], matrix[4], matrix[5]}, {matrix[6], matrix[7], matrix[8]}};
  constexpr double tolerance = 1e-6;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j <= i; ++j)
      if (!(std::fabs(dot(row[i], row[j]) - (i == j ? 1.0 : 0.0)) <= tolerance)) return Status::range;
  if (dot(cross(row[0], row[1]), row[2]) < 0) return Status::range;
  // Four times the squares of the components, and their products. Of a rotation each row is the quaternion times four
  // of its components. Else the quaternion of the nearest rotation is the eigenvector with the largest eigenvalue,
  // nearly 4 (Davenport 1968), while the other three are some 1e-6. The row of the largest component is as exact as the
  // matrix (Shepperd 1978). It is multiplied by the products twice, each of which leaves some 1e-6 of its error.
  const double xx = row[0].x, yy = row[1].y, zz = row[2].z;
  const double squares[4] = {1.0 + ((xx + yy) + zz), 1.0 + ((xx - yy) - zz), 1.0 + ((yy - xx) - zz),
                             1.0 + ((zz - xx) - yy)};
  const double x_by_w = row[2].y - row[1].z, y_by_w = row[0].z - row[2].x, z_by_w = row[1].x - row[0].y;
  const double x_by_y = row[0].y + row[1].x, x_by_z = row[0].z + row[2].x, y_by_z = row[1].z + row[2].y;
  const double products[4][4] = {{squares[0], x_by_w, y_by_w, z_by_w},
                                 {x_by_w, squares[1], x_by_y, x_by_z},
                                 {y_by_w, x_by_y, squares[2], y_by_z},
                                 {z_by_w, x_by_z, y_by_z, squares[3]}};
  int largest = 0;
  for (int k = 1; k < 4; ++k)
    if (squares[k] > squares[largest]) largest = k;
  double row_of_largest[4];
  for (int k = 0; k < 4; ++k) row_of_largest[k] = products[largest][k];
  for (int times = 0; times < 2; ++times) {
    double next[4];
    for (int k = 0; k < 4; ++k) {
      const double *const p = products[k];
      next[k] =
          (p[0] * row_of_largest[0] + p[1] * row_of_largest[1]) + (p[2] * row_of_largest[2] + p[3] * row_of_largest[3]);
    }
    for (int k = 0; k < 4; ++k) row_of_largest[k] = next[k];
  }
  const double scale = 0x1p-5 / std::sqrt(squares[largest]);
  for (int k = 0; k < 4; ++k) quaternion[k] = scale * row_of_largest[k];
  return Status::ok;
}

}  // namespace hsp
