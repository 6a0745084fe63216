// Whether parts of a crease are behind a ball, as far as that is certain without roots: from the values of some
// functions at some angles, and bounds of how they bend between two angles.
#pragma once

#include "core/extremes.hpp"
#include "maps/ball_scene.hpp"

namespace hsp {

struct CreaseEnds {
  double from, to;
};

// A part of a crease, and angles in it at equal steps.
struct PartOfCrease {
  static constexpr uint32_t steps = 8;
  CreaseEnds ends;
  double step;
  SinCos node[steps + 1];

  PartOfCrease() {}
  explicit PartOfCrease(const CreaseEnds &of) : ends(of), step((of.to - of.from) / steps) {
    const SinCos turn = sin_cos(step);
    SinCos at = sin_cos(of.from);
    for (SinCos &own : node) {
      own = at;
      at = {at.cosine * turn.cosine - at.sine * turn.sine, at.sine * turn.cosine + at.cosine * turn.sine};
    }
  }
};

// For a point let z be its height over the ball's centre, F the square of its distance from the centre less that of the
// radius, and G = F - z^2 the same for the distance in the view plane. A point with G > 0, or with z > 0 and F > 0, is
// not behind the ball. A point with F < 0, or with z < 0 and G < 0, is behind it.
class CreaseBesideBall {
 public:
  CreaseBesideBall(const Crease &crease, const SeenBall &ball) : rise_(crease.rise) {
    const Vec3 w{crease.m.x - ball.x, crease.m.y - ball.y, crease.m.z - ball.z};
    const double terms = dot(w, w) + crease.rho * crease.rho, square = ball.r * ball.r;
    z_ = w.z;
    F_ = terms - square;
    A_ = 2 * crease.rho * dot(w, crease.a);
    B_ = 2 * crease.rho * dot(w, crease.b);
    bend_F_ = std::fabs(A_) + std::fabs(B_);
    bend_G_ = 2 * crease.rho *
                  (std::fabs(w.x * crease.a.x + w.y * crease.a.y) + std::fabs(w.x * crease.b.x + w.y * crease.b.y)) +
              2 * rise_ * rise_;
    margin_ = 0x1p-30 * (square + terms);
    low_ = 0x1p-30 * ball.r;
  }

  // 1 if these parts are certainly all behind the ball, -1 if nothing of them is, else 0.
  [[gnu::noinline]] int side_of(Span<const PartOfCrease> parts) const {
    int all = 0;
    for (const PartOfCrease &part : parts) {
      Values before = at(part.node[0]);
      for (uint32_t k = 1; k <= PartOfCrease::steps; ++k) {
        const Values here = at(part.node[k]);
        const int side = side_between(before, here, part.step * part.step);
        if (side == 0 || side == -all) return 0;
        all = side;
        before = here;
      }
    }
    return all;
  }

 private:
  struct Values {
    double z, F, G;
  };
  Values at(const SinCos &t) const {
    const double z = z_ + rise_ * t.cosine, F = F_ + A_ * t.cosine + B_ * t.sine;
    return {z, F, F - z * z};
  }
  int side_between(const Values &a, const Values &b, double squared) const {
    const double highest = larger_of(a.z, b.z) + squared * rise_, lowest = smaller_of(a.z, b.z);
    if (stays_above(a.G, b.G, squared * bend_G_)) return -1;
    // Below the centre G >= F - lowest^2.
    const double below = lowest > low_ ? 0.0 : (lowest - low_) * (lowest - low_);
    if (stays_above(a.F - below, b.F - below, squared * bend_F_)) return -1;
    if (stays_above(-a.F, -b.F, squared * bend_F_)) return 1;
    if (highest < -low_ && stays_above(-a.G, -b.G, squared * bend_G_)) return 1;
    return 0;
  }
  // Whether a function is certainly above 0 between two angles, from its values there: it is above the parabola through
  // both values with the largest bend.
  bool stays_above(double first, double last, double bend) const {
    first -= margin_;
    last -= margin_;
    if (!(first > 0.0 && last > 0.0)) return false;
    const double up = std::fabs(last - first), half = 0.5 * bend;
    return up >= half || (half - up) * (half - up) < 4.0 * half * smaller_of(first, last);
  }

  double rise_, z_, F_, A_, B_, bend_F_, bend_G_, margin_, low_;
};

}  // namespace hsp
