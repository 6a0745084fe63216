#include "view/depth_order.hpp"

#include "core/sorting.hpp"
#include "exact/wide_integer.hpp"

namespace hsp {
namespace {

// Sign of direction . (c_a - c_b). The differences are below 2^52, exact in doubles; the sum of three products has an
// error of at most 4e times the sum of their sizes.
int compare_depths(const BallSet &balls, const exact::Vector &direction, uint32_t a, uint32_t b) {
  const double x = balls.x[a] - balls.x[b];
  const double y = balls.y[a] - balls.y[b];
  const double z = balls.z[a] - balls.z[b];
  const Vec3 v = exact::to_double(direction);
  const double px = v.x * x;
  const double py = v.y * y;
  const double pz = v.z * z;
  const int sign =
      exact::certain_sign(px + py + pz, 8 * unit_roundoff * (std::fabs(px) + std::fabs(py) + std::fabs(pz)));
  if (sign != 0) return sign;
  using I64 = exact::WideInteger<exact::FastLimb, 64>;
  const auto term = [](int64_t component, double difference) {
    return exact::product<128>(I64::from(component), I64::from(static_cast<int64_t>(difference)));
  };
  return (term(direction.x, x) + term(direction.y, y) + term(direction.z, z)).sign();
}

}  // namespace

bool is_farther(const BallSet &balls, const exact::Vector &direction, uint32_t a, uint32_t b) {
  const int sign = compare_depths(balls, direction, a, b);
  return sign != 0 ? sign < 0 : exact::ranks_before(balls.ball(a), balls.ball(b));
}

// The rounded depths decide where they differ by more than twice their error, 4e times the sum of three products of at
// most 2^28 by the largest difference from the origin.
void sort_by_depth(const BallSet &balls, const ViewFrame &frame, Span<DepthKey> keys) {
  const Vec3 direction = exact::to_double(frame.direction);
  double farthest = 0.0;
  for (DepthKey &key : keys) {
    const double x = balls.x[key.ball] - frame.origin.x;
    const double y = balls.y[key.ball] - frame.origin.y;
    const double z = balls.z[key.ball] - frame.origin.z;
    key.depth = direction.x * x + direction.y * y + direction.z * z;
    const double size = std::fabs(direction.x * x) + std::fabs(direction.y * y) + std::fabs(direction.z * z);
    farthest = size > farthest ? size : farthest;
  }
  const double uncertain = 16 * unit_roundoff * farthest;
  sort_in_place(keys, [&](const DepthKey &a, const DepthKey &b) {
    const double difference = a.depth - b.depth;
    if (difference < -uncertain) return true;
    if (difference > uncertain) return false;
    return is_farther(balls, frame.direction, a.ball, b.ball);
  });
}

}  // namespace hsp
