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
  exact::Vector direction{0, 0, 1};  // towards the viewer; components at most 2^28, what everything exact relies on
  // Its orthonormal axes.
  exact::DoubleVector right{1.0, 0.0, 0.0};
  exact::DoubleVector up{0.0, 1.0, 0.0};
  exact::DoubleVector towards{0.0, 0.0, 1.0};
  exact::DoubleVector origin{0.0, 0.0, 0.0};  // a lattice point

  // View coordinates of a vector.
  exact::DoubleVector turned(const exact::DoubleVector &v) const {
    return {exact::dot(v, right), exact::dot(v, up), exact::dot(v, towards)};
  }
  // View coordinates of a ball's centre. The difference is exact.
  exact::DoubleVector centre_of(const BallSet &balls, uint32_t i) const {
    return turned({balls.x[i] - origin.x, balls.y[i] - origin.y, balls.z[i] - origin.z});
  }
};

// Rounds a direction to integers and completes the axes. Status::not_finite if a component is.
Status look_from(const ViewDirection &direction, ViewFrame &frame);

// Puts the origin in the middle of the balls' centres.
void centre_on(const BallSet &balls, ViewFrame &frame);

}  // namespace hsp
