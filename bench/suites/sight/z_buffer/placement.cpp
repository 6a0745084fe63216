#include "z_buffer/placement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bench {
namespace {

using Vector = std::array<double, 3>;

Vector cross(const Vector &a, const Vector &b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector unit(const Vector &a) {
  const double length = std::hypot(a[0], a[1], a[2]);
  return {a[0] / length, a[1] / length, a[2] / length};
}

std::array<float, 3> rounded(const Vector &a) {
  return {static_cast<float>(a[0]), static_cast<float>(a[1]), static_cast<float>(a[2])};
}

void turn(const std::array<float, 3> &axis, const std::vector<float> &x, const std::vector<float> &y,
          const std::vector<float> &z, std::vector<float> &out) {
  for (size_t i = 0; i < out.size(); ++i) out[i] = axis[0] * x[i] + axis[1] * y[i] + axis[2] * z[i];
}

struct Range {
  float low = std::numeric_limits<float>::infinity();
  float high = -std::numeric_limits<float>::infinity();
};

Range range_of(const std::vector<float> &centre, const std::vector<float> &radius) {
  Range range;
  for (size_t i = 0; i < centre.size(); ++i) {
    range.low = std::min(range.low, centre[i] - radius[i]);
    range.high = std::max(range.high, centre[i] + radius[i]);
  }
  return range;
}

void scale(std::vector<float> &values, float middle, float factor, float shift) {
  for (float &value : values) value = (value - middle) * factor + shift;
}

}  // namespace

Axes axes_towards(const std::array<double, 3> &direction) {
  const Vector towards = unit(direction);
  const bool along_y = std::abs(towards[1]) > 0.999;
  const Vector right = unit(cross(along_y ? Vector{0, 0, 1} : Vector{0, 1, 0}, towards));
  return {rounded(right), rounded(cross(towards, right)), rounded(towards)};
}

std::vector<std::array<double, 3>> spread_directions(size_t count) {
  const double golden_angle = 2.399963229728653;
  std::vector<std::array<double, 3>> directions;
  for (size_t i = 0; i < count; ++i) {
    const double height = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(count);
    const double across = std::sqrt(1 - height * height);
    const double angle = golden_angle * static_cast<double>(i) + 0.3;
    directions.push_back({across * std::cos(angle), height, across * std::sin(angle)});
  }
  return directions;
}

Placement::Placement(const std::vector<double> &xyz, const std::vector<double> &radius) {
  Vector middle{};
  for (size_t i = 0; i < xyz.size(); ++i) middle[i % 3] += xyz[i] / static_cast<double>(radius.size());
  for (size_t ball = 0; ball < radius.size(); ++ball) {
    x_.push_back(static_cast<float>(xyz[3 * ball] - middle[0]));
    y_.push_back(static_cast<float>(xyz[3 * ball + 1] - middle[1]));
    z_.push_back(static_cast<float>(xyz[3 * ball + 2] - middle[2]));
    radius_.push_back(static_cast<float>(radius[ball]));
  }
  placed_ = {x_, y_, z_, radius_};
}

const PlacedBalls &Placement::place(const Axes &axes) {
  turn(axes.right, x_, y_, z_, placed_.x);
  turn(axes.up, x_, y_, z_, placed_.y);
  turn(axes.towards, x_, y_, z_, placed_.z);
  const Range across = range_of(placed_.x, radius_);
  const Range upwards = range_of(placed_.y, radius_);
  const float larger = std::max(across.high - across.low, upwards.high - upwards.low);
  const float factor = image_side / (larger * (1 + 2 * image_margin));
  scale(placed_.x, (across.low + across.high) / 2, factor, image_side / 2.0F);
  scale(placed_.y, (upwards.low + upwards.high) / 2, factor, image_side / 2.0F);
  scale(placed_.z, 0, factor, 0);
  for (size_t i = 0; i < radius_.size(); ++i) placed_.radius[i] = radius_[i] * factor;
  return placed_;
}

}  // namespace bench
