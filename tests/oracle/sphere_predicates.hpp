// The geometric questions that decide the boundary of a union of balls, answered naively: determinants without any
// factoring, in integers of any size. If the value for the balls as given is zero, simulation of simplicity decides, by
// the library's rule but in polynomials of infinitesimals 1 >> eps_0 >> eps_1 >> ... Every squared radius w grows by
//   w eps_0 + eps_1 + x eps_2 + y eps_3 + z eps_4 + M(x, y, z) eps_5,
// where x, y, z is the centre and M a quadratic form, and last by an infinitesimal of the ball's own, the larger the
// lower the ball's rank.
//
// Everything is seen from one ball a. With y = x - c_a the sphere of a is |y|^2 = w_a (w = radius squared), and a ball
// b contains the points of that sphere with 2 v.y > g, where v = c_b - c_a and g = |v|^2 + w_a - w_b.
#pragma once

#include <cstdint>
#include <vector>

#include "lattice_ball.hpp"

namespace oracle {

// The open half space 2 v.y > g that a ball cuts off a sphere (a cap), or, without a ball, 2 v.y > 0.
struct Cap {
  Vector normal = {0, 0, 0};
  uint32_t ball = no_ball;
};

// One of the two points where the circles of two caps cross: foot + side * (positive number) * (first x second).
struct Crossing {
  Cap first;
  Cap second;
  int side = +1;
};

enum class PairRelation { disjoint, circle, first_inside_second, second_inside_first };

// A set of balls with enlarged weights, as said in the first lines of this file.
class TiedBalls {
 public:
  explicit TiedBalls(Balls balls) : balls_(std::move(balls)), rank_(tie_ranks(balls_)) {}

  [[nodiscard]] const Balls &balls() const { return balls_; }
  [[nodiscard]] uint32_t size() const { return static_cast<uint32_t>(balls_.size()); }
  [[nodiscard]] uint32_t rank(uint32_t ball) const { return rank_[ball]; }

  // The factor of eps_level in a ball's weight.
  static constexpr unsigned levels = 6;
  [[nodiscard]] Int128 growth(unsigned level, uint32_t ball) const;

  // The cap that ball b cuts off the sphere of ball a.
  [[nodiscard]] Cap cap(uint32_t a, uint32_t b) const { return {centre_difference(balls_[a], balls_[b]), b}; }

  [[nodiscard]] PairRelation pair(uint32_t a, uint32_t b) const;

  // Do the circles of two caps cross on the sphere of ball a? (If so, in two points.)
  [[nodiscard]] bool circles_cross(uint32_t a, const Cap &first, const Cap &second) const;

  // The same for the balls as given: +1 they cross, 0 they touch or coincide, -1 they are apart.
  [[nodiscard]] int circles_cross_as_given(uint32_t a, const Cap &first, const Cap &second) const;

  // Does the circle of a cap that another cap's circle does not cross lie inside that other cap?
  [[nodiscard]] bool circle_inside(uint32_t a, const Cap &circle, const Cap &other) const;

  // Does the point where two circles cross lie in a further cap?
  [[nodiscard]] bool crossing_inside(uint32_t a, const Crossing &point, const Cap &cap) const;

  // On which side of a plane through the centre of ball a does the point where two circles cross lie? +1 where
  // 2 normal.y > 0. Planes are not inflated: the answer can be 0 if one of the two circles is itself cut by a plane.
  [[nodiscard]] int crossing_side(uint32_t a, const Crossing &point, const Vector &normal) const;

  // crossing_inside for the balls as given: +1 inside, 0 on the cap's circle, -1 outside. The circles must cross or
  // touch.
  [[nodiscard]] int crossing_inside_as_given(uint32_t a, const Crossing &point, const Cap &cap) const;

 private:
  Balls balls_;
  std::vector<uint32_t> rank_;
};

}  // namespace oracle
