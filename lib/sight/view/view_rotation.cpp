#include "view/view_rotation.hpp"

namespace hsp {

SinCos direction_of_degrees(double degrees) {
  const double turns = degrees / 360.0;
  const double whole = static_cast<double>(static_cast<int64_t>(turns));
  const double quarters = (degrees - whole * 360.0) / 90.0;
  if (quarters == static_cast<double>(static_cast<int64_t>(quarters))) {
    switch (static_cast<int64_t>(quarters) & 3) {
      case 0:
        return {1.0, 0.0};
      case 1:
        return {0.0, 1.0};
      case 2:
        return {-1.0, 0.0};
      default:
        return {0.0, -1.0};
    }
  }
  return sin_cos(quarters * (pi / 2));
}

// The balls are turned by R = R_z R_y R_x; seen from them, the viewer's axes are the rows of R.
Status direction_of_rotation(double x, double y, double z, ViewDirection &direction) {
  if (!is_finite(x) || !is_finite(y) || !is_finite(z)) return Status::not_finite;
  const auto too_large = [](double angle) { return std::fabs(angle) > largest_rotation; };
  if (too_large(x) || too_large(y) || too_large(z)) return Status::range;
  const SinCos a = direction_of_degrees(x);
  const SinCos b = direction_of_degrees(y);
  const SinCos c = direction_of_degrees(z);
  direction = {{-b.sine, b.cosine * a.sine, b.cosine * a.cosine},
               {c.sine * b.cosine, c.sine * b.sine * a.sine + c.cosine * a.cosine,
                c.sine * b.sine * a.cosine - c.cosine * a.sine}};
  return Status::ok;
}

}  // namespace hsp
