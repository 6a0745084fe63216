#include "view/view_frame.hpp"

namespace hsp {
namespace {

using exact::Vector;

constexpr double largest_component = 0x1p28;

// The direction of a vector as integers with a largest component of 2^28; zero stays zero.
Vector rounded(const double v[3]) {
  double largest = 0.0;
  for (int k = 0; k < 3; ++k) largest = std::fabs(v[k]) > largest ? std::fabs(v[k]) : largest;
  if (largest == 0.0) return {0, 0, 0};
  // Divided first: the quotient is at most 1, whatever the lengths.
  return {nearest(v[0] / largest * largest_component), nearest(v[1] / largest * largest_component),
          nearest(v[2] / largest * largest_component)};
}

Vec3 unit(const Vec3 &v) {
  const double length = std::sqrt(dot(v, v));
  return {v.x / length, v.y / length, v.z / length};
}

// The cross products of directions stay below 2^58.
Vector right_of(const Vector &up, const Vector &towards) {
  constexpr Vector y{0, 1, 0};
  constexpr Vector z{0, 0, 1};
  const Vector across = cross(up, towards);
  if (!exact::is_zero(across)) return across;
  const Vector across_y = cross(y, towards);
  return exact::is_zero(across_y) ? cross(z, towards) : across_y;
}

}  // namespace

Status look_from(const ViewDirection &direction, ViewFrame &frame) {
  for (int k = 0; k < 3; ++k) {
    if (!is_finite(direction.towards[k]) || !is_finite(direction.up[k])) return Status::not_finite;
  }
  frame.direction = rounded(direction.towards);
  if (exact::is_zero(frame.direction)) frame.direction = {0, 0, static_cast<int64_t>(largest_component)};
  frame.towards = unit(exact::to_double(frame.direction));
  frame.right = unit(exact::to_double(right_of(rounded(direction.up), frame.direction)));
  frame.up = cross(frame.towards, frame.right);
  return Status::ok;
}

void centre_on(const BallSet &balls, ViewFrame &frame) {
  const auto middle = [&balls](Span<double> coordinate) {
    double low = coordinate[0];
    double high = coordinate[0];
    for (uint32_t i = 1; i < balls.n; ++i) {
      low = coordinate[i] < low ? coordinate[i] : low;
      high = coordinate[i] > high ? coordinate[i] : high;
    }
    return static_cast<double>(nearest((low + high) / 2));
  };
  frame.origin = balls.n == 0 ? Vec3{0.0, 0.0, 0.0} : Vec3{middle(balls.x), middle(balls.y), middle(balls.z)};
}

}  // namespace hsp
