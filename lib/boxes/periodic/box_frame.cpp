#include "periodic/box_frame.hpp"

#include <bit>
#include <cmath>

namespace hsp {
namespace {

// The power of two in the largest component; 0 if that is not a normal number.
double scale_of(const double vector[9]) {
  double largest = 0.0;
  for (int k = 0; k < 9; ++k) {
    const double size = std::fabs(vector[k]);
    largest = size > largest ? size : largest;
  }
  return std::bit_cast<double>(std::bit_cast<uint64_t>(largest) & UINT64_C(0x7FF0000000000000));
}

// v without its part along a unit vector. Subtracted twice: the first time leaves the rounding of v, which may be most
// of the rest.
Vec3 beside(const Vec3 &v, const Vec3 &unit) {
  const Vec3 rest = combine(1.0, v, -dot(v, unit), unit);
  return combine(1.0, rest, -dot(rest, unit), unit);
}

// Makes a vector one of length 1. Divides each component, so that axes of the caller stay exact.
bool make_unit(Vec3 &v) {
  const double length = std::sqrt(dot(v, v));
  v = {v.x / length, v.y / length, v.z / length};
  return length > 0.0;
}

}  // namespace

bool BoxFrame::set(const double vector[9]) {
  *this = {};
  if (vector[1] == 0.0 && vector[2] == 0.0 && vector[5] == 0.0) return true;
  const double scale = scale_of(vector);
  if (scale == 0.0) return false;
  const auto scaled = [&](int row) {
    return Vec3{vector[3 * row] / scale, vector[3 * row + 1] / scale, vector[3 * row + 2] / scale};
  };
  Vec3 x = scaled(0);
  if (!make_unit(x)) return false;
  Vec3 y = beside(scaled(1), x);
  if (!make_unit(y)) return false;
  axis_[0] = x;
  axis_[1] = y;
  axis_[2] = cross(x, y);
  turns_ = true;
  return true;
}

bool BoxFrame::operator==(const BoxFrame &other) const {
  bool same = true;
  for (int k = 0; k < 3; ++k) {
    const Vec3 &own = axis_[k], &its = other.axis_[k];
    same = same && own.x == its.x && own.y == its.y && own.z == its.z;
  }
  return same;
}

Strain BoxFrame::rows_turned_back(const Strain &rows) const {
  Strain result = rows;
  for (int row = 0; row < 3; ++row) turn_back(result.by + 3 * row);
  return result;
}

Strain BoxFrame::strain_turned_back(const Strain &strain) const {
  Strain result = rows_turned_back(strain);
  for (int column = 0; column < 3; ++column) {
    double *const by = result.by + column;
    const Vec3 own = turned_back({by[0], by[3], by[6]});
    by[0] = own.x;
    by[3] = own.y;
    by[6] = own.z;
  }
  return result;
}

}  // namespace hsp
