// The predicates' polynomials by naive determinants of inner products, in integers of any size that is needed, either
// for the balls as given or for balls that are really inflated by tiny amounts. Shares no formula and no code with
// lib/: neither the factored sign of A^2 - B^2 D nor a derivative occurs here.
//
// The inflation. Weights become w + eps_rank with eps_0 = 2^-64g, eps_1 = 2^-3*64g, eps_2 = 2^-7*64g, eps_3 =
// 2^-15*64g for a gap of g limbs. All values are polynomials in the eps with integer coefficients and of degree at most
// 2: h and W are linear in the weights, A and beta are linear in h, D is quadratic in h and linear in W, and so A^2 -
// B^2 D has degree 2. The 15 monomials of degree at most 2 in the order of infinitely small numbers are
//   1 > e0 > e0^2 > e1 > e1 e0 > e1^2 > e2 > e2 e0 > e2 e1 > e2^2 > e3 > ...
// with exponents 0 1 2 3 4 6 7 8 10 14 15 16 18 22 30 times 64g bits: neighbours differ by a factor of at least 2^64g.
// If all coefficients stay below 2^c and 64g >= c + 4, then the first non-zero coefficient, at least 1 in absolute,
// outweighs the at most 14 others together, and the sign is that of infinitesimal inflation. With |v| <= L, W <= L^2
// and |h| <= L^2 the largest are those of A^2 and B^2 D, together below 9 L^12 + 4 L^12 for the constant and less than
// 2^6 L^10 for the others:
//   L <= 2^31: c = 376, g = 6;       L <= 2^9: c = 112, g = 2.
#pragma once

#include <cstdint>

#include "perturbation_integer.hpp"

namespace perturbation {

struct Ball {
  int64_t centre[3];
  int64_t radius;
  uint32_t index;
};

// Four balls, their ranks, and how far they are inflated.
class Balls {
 public:
  // gap in limbs; 0: as given.
  Balls(const Ball (&four)[4], int gap);

  const Ball &operator[](int k) const { return ball_[k]; }
  // Weights and everything that is linear in them are in units of 2^-unit_bits.
  int unit_bits() const { return 64 * 15 * gap_; }
  Integer weight(int k) const;
  int rank(int k) const { return rank_[k]; }

 private:
  Ball ball_[4];
  int rank_[4];
  int gap_;
};

enum class Relation { disjoint, circle, first_in_second, second_in_first, tangent };  // tangent only if not inflated

Relation relation(const Balls &balls, int a, int b);

// A half-space v.y >= h on the sphere of one ball, y = 2 (x - centre); of another ball or of no ball.
struct HalfSpace {
  int64_t v[3];
  Integer h;  // times 2^unit_bits
};

HalfSpace half_space(const Balls &balls, int origin, int other);
HalfSpace half_space_of_plane(const Balls &balls, const int64_t (&v)[3], int64_t h);

// The sphere of one ball.
struct Origin {
  Integer W;  // 4 w times 2^unit_bits
  int unit_bits;

  Origin(const Balls &balls, int origin) : W(balls.weight(origin) * Integer(4)), unit_bits(balls.unit_bits()) {}

  // Half a Cayley-Menger determinant; times 2^(2 unit_bits).
  Integer D(const HalfSpace &P, const HalfSpace &Q) const;
  // Times 2^unit_bits.
  Integer beta(const HalfSpace &P, const HalfSpace &R) const;
  Integer A(const HalfSpace &P, const HalfSpace &Q, const HalfSpace &R) const;
  Integer B(const HalfSpace &P, const HalfSpace &Q, const HalfSpace &R) const;
  // The determinant of the inner products bordered by h and W; times 2^(2 unit_bits).
  Integer F(const HalfSpace &P, const HalfSpace &Q, const HalfSpace &R) const;
  // |u x v|^2
  Integer N(const HalfSpace &P, const HalfSpace &Q) const;

  // The sign of A + s B sqrt(D) for a D >= 0, by squaring: where the point p^s of P and Q lies to R.
  static int point_sign(const Integer &D, const Integer &A, const Integer &B, int s);
};

}  // namespace perturbation
