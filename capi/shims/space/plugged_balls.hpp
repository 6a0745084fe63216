// Balls with plugs in the mouths of pockets.
#pragma once

#include <initializer_list>

#include "pore_records.hpp"

namespace hsp::capi {

// The balls that pores were computed of, grown by the narrow probe of their pockets, then the plugs of all mouths.
class PluggedBalls {
 public:
  explicit PluggedBalls(const hsp_pores &pores) : pores_(pores), around_(pores.balls_around()) {}

  uint32_t given() const { return pores_.ball_count(); }
  uint32_t size() const { return given() + pores_.builder.pockets().all_mouths().size(); }
  // Writes ball k as lengths.
  void put(uint32_t k, double xyz[3], double &radius) const {
    const exact::LatticeBall ball = (*this)[k];
    put_position(pores_, exact::to_double(ball.centre), xyz);
    radius = radius_of(ball);
  }
  // Whether other pores were computed of these balls, rounded to the same lattice or a coarser one, in the same box.
  // They may have further balls behind these.
  bool are_those_of(const hsp_pores &plugged) const {
    if (plugged.in_box != pores_.in_box || plugged.ball_count() < size()) return false;
    const BallsAround around = plugged.balls_around();
    if (around.box() != nullptr && !is_same_box(*around.box(), plugged.lattice())) return false;
    for (uint32_t k = 0; k < size(); ++k) {
      if (!is_same_ball(k, around, plugged.lattice())) return false;
    }
    return true;
  }

 private:
  exact::LatticeBall operator[](uint32_t k) const {
    if (k >= given()) {
      const uint32_t mouth = pores_.builder.pockets().all_mouths()[k - given()];
      return plug_of(pores_.builder.pores(), around_, pores_.gates()[mouth], pores_.narrow_steps);
    }
    exact::LatticeBall ball = around_.ball({k, {}});
    ball.radius = grown_radius(ball.radius, pores_.narrow_steps);
    return ball;
  }
  double radius_of(const exact::LatticeBall &ball) const {
    return pores_.lattice().length(static_cast<double>(ball.radius));
  }
  bool is_same_ball(uint32_t k, const BallsAround &around, const exact::Lattice &lattice) const {
    const exact::LatticeBall own = (*this)[k];
    double place[3];
    to_array(lengths_of(pores_, exact::to_double(own.centre)), place);
    const exact::LatticeBall there = around.ball({k, {}});
    exact::Vector centre;
    BoxShift home;
    if (!lattice.round(place, centre)) return false;
    if (around.box() != nullptr && around.box()->wrap(centre, home) != Status::ok) return false;
    const double slack = slack_on(lattice);
    const exact::Vector off = centre - there.centre;
    return static_cast<double>(dot(off, off)) <= 3.0 * slack &&
           is_near(lattice.steps(radius_of(own)), there.radius, slack);
  }
  // On a coarser lattice a number that was rounded more than once may differ by a step.
  double slack_on(const exact::Lattice &lattice) const { return lattice.step() > pores_.lattice().step() ? 1.0 : 0.0; }
  static bool is_near(double own, int64_t other, double slack) {
    return std::fabs(own - static_cast<double>(other)) <= slack + 0.5;
  }
  bool is_same_box(const PeriodicBox &box, const exact::Lattice &lattice) const {
    const auto is_same = [&](int64_t own, int64_t other) {
      return is_near(lattice.steps(pores_.lattice().length(static_cast<double>(own))), other, slack_on(lattice));
    };
    bool same = around_.box()->frame() == box.frame();
    for (const uint32_t k : {0U, 1U, 2U}) {
      const exact::Vector &own = around_.box()->given(k), &other = box.given(k);
      same = same && is_same(own.x, other.x) && is_same(own.y, other.y) && is_same(own.z, other.z);
    }
    return same;
  }

  const hsp_pores &pores_;
  BallsAround around_;
};

}  // namespace hsp::capi
