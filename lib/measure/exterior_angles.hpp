// The sum of the angles by which loops turn at their vertices, each in [0, pi], with one arc tangent for all of them:
// the product of their phases, and the number of whole turns.
#pragma once

#include "core/elementary_simd.hpp"

namespace hsp {

class ExteriorAngleSum {
 public:
  void add_angle(double angle) { angles_ += angle; }

  // Two angles in [0, pi] by their directions: y >= +0, and a length in [2^-7, 1] up to rounding.
  //
  // Whole turns are counted by half-planes, given by the sign of Y: the product (X, Y) is in the upper one for angles
  // in [0, pi], in the lower one for [pi, 2 pi], where pi is (-1, -0) and 2 pi is (1, -0), and a turn is complete when
  // it leaves the lower one for the upper one. Rounding cannot make the count wrong. The new Y is X y + Y x. From the
  // upper half-plane the new angle lies in [0, 2 pi]; it would be mistaken for one near the other end only if the sign
  // of the new Y were wrong near 0, where X, x > 0 and both terms are >= +0, or near 2 pi, where X, x < 0 and both are
  // <= -0. From the lower one it lies in [pi, 3 pi]: near pi X < 0 < x and both terms are <= -0, near 3 pi x < 0 < X
  // and both are >= +0. Elsewhere the count and the angle change together.
  void add_directions(const Lanes &x, const Lanes &y) {
    const Lanes X = x_ * x - y_ * y;
    const Lanes Y = x_ * y + y_ * x;
    turns_ += std::bit_cast<LaneCount>(y_) >> 63 & ~(std::bit_cast<LaneCount>(Y) >> 63);
    x_ = X;
    y_ = Y;
  }
  // To be called after at most 14 directions: together they are no shorter than 2^-98, so that the product stays above
  // 2^-198 and does not vanish.
  void rescale() {
    constexpr double tiny = 0x1p-100;
    const LaneMask vanishing = (absolute(x_) < tiny) & (absolute(y_) < tiny);
    const Lanes scale = select(vanishing, all_lanes(1.0 / tiny), all_lanes(1.0));
    x_ *= scale;
    y_ *= scale;
  }

  double total() const {
    const Lanes rest = turn_angle(x_, y_);
    double turns = static_cast<double>(turns_[0] + turns_[1]);
    // (1, -0) stands for a whole turn.
    for (uint32_t k = 0; k < lane_count; ++k) turns += y_[k] == 0.0 && std::signbit(y_[k]) && x_[k] > 0.0 ? 1.0 : 0.0;
    return angles_ + (2 * pi * turns + (rest[0] + rest[1]));
  }

 private:
  typedef uint64_t LaneCount __attribute__((vector_size(16)));

  Lanes x_{1.0, 1.0}, y_{0.0, 0.0};
  LaneCount turns_{0, 0};
  double angles_ = 0.0;
};

}  // namespace hsp
