// The coordinates of a view: x right, y up, z towards the viewer.
#pragma once

#include "core/status.hpp"
#include "exact/filter.hpp"
#include "model/ball_set.hpp"

namespace hsp {

struct ViewDirection {
  double towards[3];
  double up[3];
};

struct ViewFrame {
  exact::Vector direction{0, 0, 1};  // towards the viewer, for exact questions; components at most 2^28
  // The orthonormal axes of the view.
  Vec3 right{1.0, 0.0, 0.0};
  Vec3 up{0.0, 1.0, 0.0};
  Vec3 towards{0.0, 0.0, 1.0};
  Vec3 origin{0.0, 0.0, 0.0};  // a lattice point

  // Whether another frame has the same coordinates.
  bool is_same(const ViewFrame &other) const {
    const auto same = [](const Vec3 &a, const Vec3 &b) { return a.x == b.x && a.y == b.y && a.z == b.z; };
    return same(right, other.right) && same(up, other.up) && same(towards, other.towards) && same(origin, other.origin);
  }
  // View coordinates of a vector.
  Vec3 to_view(const Vec3 &v) const { return {dot(v, right), dot(v, up), dot(v, towards)}; }
  // View coordinates of a ball's centre. The difference is exact.
  Vec3 centre_of(const BallSet &balls, uint32_t i) const {
    return to_view({balls.x[i] - origin.x, balls.y[i] - origin.y, balls.z[i] - origin.z});
  }
};

// Rounds a direction to integers and completes the axes. Status::not_finite if a component is not finite.
Status look_from(const ViewDirection &direction, ViewFrame &frame);

// Puts the origin in the middle of the balls' centres.
void centre_on(const BallSet &balls, ViewFrame &frame);

}  // namespace hsp
