// The exact order of the points where a ray enters balls.
//
// Let u be the vector from the ray's origin to the centre of a ball of radius r, and d the ray's direction. The points
// origin + t d of the sphere have D t^2 - 2 B t + C = 0 with D = d.d, B = u.d and C = u.u - r^2, so that the ray enters
// at t = (B - sqrt(B^2 - D C)) / D. D is one for all balls. With |u_k| <= 2^51, |d_k| < 2^53 and r < 2^30 all of B, C
// and D are below 2^108. A discriminant that is not negative is at most D r^2 < 2^168 (Lagrange's identity); others
// are above -2^217. Sums of two square roots are compared by squaring twice.
//
// As an example the ray from 0 along d = (1,0,0) and the ball of radius 5 at (13,3,0): D = 1, B = 13, C = 178 - 25 =
// 153, and it enters at t = 13 - sqrt(169 - 153) = 9.
#pragma once

#include "exact/lattice_ball.hpp"
#include "exact/power.hpp"
#include "lanes/floating_point.hpp"

namespace hsp::exact {

// A ray from a lattice point along an integer vector, whose components are below 2^53 in size and not all 0.
struct LatticeRay {
  Vector origin, direction;
};

using Integer128 = WideInteger<FastLimb, 128>;
using Integer256 = WideInteger<FastLimb, 256>;

// How a ray's line lies to a ball.
struct RayCut {
  Integer128 along;         // B
  Integer128 power;         // C, of the origin
  Integer256 discriminant;  // B^2 - D C; the line misses the closed ball if it is negative

  RayCut(const LatticeRay &ray, const LatticeBall &ball) {
    const Vector u = ball.centre - ray.origin;
    along = dot128<FastLimb>(u, ray.direction);
    power = exact::power(u, ball.radius);
    discriminant = product<256>(along, along) - product<256>(squared_length(ray.direction), power);
  }

  // Whether the ray meets the closed ball, if its origin lies outside.
  bool meets() const { return along.sign() > 0 && discriminant.sign() >= 0; }
  // The t at which such a ray enters the ball, if it meets it. The relative error is below 2^-50: nothing cancels.
  double entry() const { return power.to_double() / (along.to_double() + std::sqrt(discriminant.to_double())); }
};

// Sign of E + sqrt(b) - sqrt(a) for 0 <= E < 2^107 and 0 <= a, b < 2^168. If F is negative, E^2 < a, so that no term of
// the last line exceeds 2^339.
inline int sign_with_two_roots(const Integer128 &E, const Integer256 &b, const Integer256 &a) {
  const Integer256 squared = product<256>(E, E);
  const Integer256 F = squared + b - a;
  const bool mixed = squared.sign() > 0 && b.sign() > 0;  // whether 2 E sqrt(b), which F lacks, is not 0
  if (!F.negative()) return F.sign() > 0 || mixed ? 1 : 0;
  const auto once = product<384>(squared, b);
  const auto twice = once + once;
  return (twice + twice - product<384>(F, F)).sign();
}

// Whether a ray enters the ball of the first cut before (-1), together with (0) or after (1) that of the second. The
// ray meets both.
inline int compare_entries(const RayCut &first, const RayCut &second) {
  const Integer128 E = first.along - second.along;
  if (E.negative()) return -sign_with_two_roots(-E, first.discriminant, second.discriminant);
  return sign_with_two_roots(E, second.discriminant, first.discriminant);
}

}  // namespace hsp::exact
