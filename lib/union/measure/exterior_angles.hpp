// The sum of the angles by which loops turn at their vertices, each in [0, pi], with one arc tangent for all angles in
// a lane. It keeps the product of their directions as complex numbers, and the number of whole turns.
#pragma once

#include "lanes/angle.hpp"

namespace hsp {
namespace {

template <uint32_t n>
class ExteriorAngleSum {
 public:
  using L = Wide<double, n>;
  using Real = typename L::Real;
  using Mask = typename L::Mask;

  // With more, the product might leave the range of doubles.
  static constexpr uint32_t most_directions = 8;

  // Adds angles in [0, pi], one in each lane, given by directions (x, y) with y >= +0 and a length in [2^-7, 2^124].
  //
  // The sign of Y gives the half-plane of the product (X, Y): the upper one for sums in [0, pi], the lower one for sums
  // in [pi, 2 pi], where pi is (-1, -0) and 2 pi is (1, -0). A turn is complete when the product goes from the lower to
  // the upper half-plane. Rounding cannot make the count wrong: the new Y is X y + Y x. From the upper half-plane the
  // new sum lies in [0, 2 pi]. It would be mistaken for one near the other end only if the sign of the new Y were wrong
  // near 0, where X, x > 0 and both terms are >= +0, or near 2 pi, where X, x < 0 and both are <= -0. From the lower
  // half-plane the new sum lies in [pi, 3 pi]: near pi X < 0 < x and both terms are <= -0, near 3 pi x < 0 < X and both
  // are >= +0. Elsewhere the count and the angle change together.
  void add_directions(const Real &x, const Real &y) {
    const Real X = x_ * x - y_ * y;
    const Real Y = x_ * y + y_ * x;
    turns_ += L::sign_bits(L::bits(y_) & ~L::bits(Y));
    x_ = X;
    y_ = Y;
  }

  // The sum in each lane is 2 pi turns() + angles(), with angles in [-pi, pi]. A sum in the lower half-plane has one
  // turn more than are complete.
  Mask turns() const { return turns_ + L::sign_bits(L::bits(y_)); }
  Real angles() const { return signed_angle<L>(x_, y_); }

 private:
  Real x_ = L::all(1.0), y_ = L::all(0.0);
  Mask turns_{};
};

}  // namespace
}  // namespace hsp
