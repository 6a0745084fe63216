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

// Rounded depths decide if they differ by more than twice their error. The error is 4e times the sum of three products
// of at most 2^28 by the largest difference from the origin. Depths are rounded integers, so that a spread is at
// least 1.
void sort_by_depth(const BallSet &balls, const ViewFrame &frame, Span<DepthKey> keys, Span<uint32_t> scratch,
                   Patience &patience) {
  if (keys.empty()) return;
  const Vec3 direction = exact::to_double(frame.direction);
  double largest = 0.0;
  const auto depth_of = [&](uint32_t ball) {
    const double x = balls.x[ball] - frame.origin.x;
    const double y = balls.y[ball] - frame.origin.y;
    const double z = balls.z[ball] - frame.origin.z;
    const double size = std::fabs(direction.x * x) + std::fabs(direction.y * y) + std::fabs(direction.z * z);
    largest = size > largest ? size : largest;
    return direction.x * x + direction.y * y + direction.z * z;
  };
  double farthest = depth_of(keys[0].ball);
  double nearest = farthest;
  for (DepthKey &key : keys) {
    key.depth = depth_of(key.ball);
    farthest = key.depth < farthest ? key.depth : farthest;
    nearest = key.depth > nearest ? key.depth : nearest;
  }
  const double uncertain = 16 * unit_roundoff * largest;
  const double part_of_spread = nearest > farthest ? 1.0 / (nearest - farthest) : 0.0;
  sort_by_slot(
      keys, scratch,
      [&](const DepthKey &key, uint32_t slots) {
        const uint32_t slot =
            static_cast<uint32_t>((key.depth - farthest) * part_of_spread * static_cast<double>(slots));
        return slot < slots ? slot : slots - 1;
      },
      [&](const DepthKey &a, const DepthKey &b) {
        if (!patience.allows(50)) return false;
        const double difference = a.depth - b.depth;
        if (difference < -uncertain) return true;
        if (difference > uncertain) return false;
        return is_farther(balls, frame.direction, a.ball, b.ball);
      });
}

}  // namespace hsp
