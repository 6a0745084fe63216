// The sum of the angles by which a loop turns at its vertices, each in [0, pi], with one arc tangent for all of them:
// the product of their phases, and the number of whole turns.
#pragma once

#include "measure/turn_angle.hpp"

namespace hsp {

class LoopTurn {
 public:
  // An angle in [0, pi] by its direction: y >= 0, and the length is in [2^-20, 2].
  //
  // The turns are counted by half-planes: the product is in the upper one for angles in [0, pi), in the lower one for
  // [pi, 2 pi), and a turn is complete when it leaves the lower one for the upper one. Rounding cannot make the count
  // wrong. Let (X, Y) be the product so far, so that the new Y is X y + Y x. From the upper half-plane the new angle
  // lies in [0, 2 pi): it would be taken for one near the other end only if the sign of the new Y were wrong near 0,
  // where X, x > 0 and both terms are >= 0, or near 2 pi, where X, x < 0 and Y > 0 and both terms are <= 0 with the
  // second below 0. From the lower one it lies in [pi, 3 pi): near pi X < 0 < x and both terms are <= 0, near 3 pi
  // x < 0 < X and Y < 0 and both are >= 0, the second above 0. Elsewhere the count and the angle change together.
  void add_direction(double x, double y) {
    const double X = x_ * x - y_ * y;
    const double Y = x_ * y + y_ * x;
    const uint32_t lower =
        static_cast<uint32_t>(Y < 0.0) | (static_cast<uint32_t>(Y == 0.0) & static_cast<uint32_t>(X < 0.0));
    turns_ += lower_ & ~lower;
    lower_ = lower;
    x_ = X;
    y_ = Y;
    constexpr double tiny = 0x1p-600;
    if (std::fabs(X) < tiny && std::fabs(Y) < tiny) {
      x_ = X / tiny;
      y_ = Y / tiny;
    }
  }
  void add_angle(double angle) { angles_ += angle; }

  double total() const { return angles_ + (2 * pi * turns_ + turn_angle(x_, y_)); }

 private:
  double x_ = 1.0, y_ = 0.0;
  double angles_ = 0.0;
  uint32_t turns_ = 0;
  uint32_t lower_ = 0;
};

}  // namespace hsp
