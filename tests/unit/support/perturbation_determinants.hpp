// The predicates' polynomials by naive determinants of inner products, in integers of any size that is needed, either
// for the balls as given or for balls that are really inflated by tiny amounts. Shares no formula and no code with
// lib/: neither the factored sign of A^2 - B^2 D nor a derivative occurs here.
//
// The inflation. With e = 2^-64 and a gap of g, weights become w + sum of a_k e^(g k) with the amounts a_1 = w, a_3 =
// 1, a_4 to a_6 the centre's coordinates, a_7 a quadratic form of them, and 1 at k = 8 + rank. Linear polynomials, beta
// and A, get the sign of their first coefficient that is not 0, if all coefficients stay below 2^c and 64g >= c + 4.
// Quadratic ones, D and A^2 - B^2 D, are decided by their terms in e^0, e^g and e^2g, or the answers differ: the next
// term is below these three. With |v| <= L, W <= L^2 and |h| <= L^2 the largest coefficients are those of A^2 and B^2
// D, together below 9 L^12 + 4 L^12 for the constant, and with amounts below 2^12 L^2 less than 2^18 L^12 for the
// others:
//   L <= 2^31: c = 390, g = 7;       L <= 2^9: c = 126, g = 3.
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
  // gap: the g of the inflation above, in limbs of 64 bits; 0 for the balls as given.
  Balls(const Ball (&four)[4], int gap);

  const Ball &operator[](int k) const { return ball_[k]; }
  // Weights and everything that is linear in them are in units of 2^-unit_bits.
  int unit_bits() const { return 64 * 11 * gap_; }
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
