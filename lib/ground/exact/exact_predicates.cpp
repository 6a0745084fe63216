// The exact stage, with integers of 64 to 256 bits.
//
// As an example the ball of radius 5 at 0, so that W = 4 * 25, and P, Q and R the balls of radius 5 at (6,0,0), (0,6,0)
// and (0,0,6): each has h = 6 * 6 + 25 - 25 = 36.
//   n = u x v = (0, 0, 36)       q = h_P v - h_Q u = (-216, 216, 0)
//   D = W n.n - q.q = 129600 - 93312 = 36288 > 0:  the circles of P and Q cross,
//       at y = (q x n +- sqrt(D) n) / n.n = (6, 6, +-5.29), which is x = y / 2 = (3, 3, +-2.65), and 9 + 9 + 7 = 25
//   B = n.z = 216                H = q x z + h_R n = (1296, 1296, 1296)
//   F = W B^2 - H.H = 4665600 - 5038848 < 0:       the three planes meet outside the sphere, in y = (6, 6, 6),
//       so that R holds neither point: z.y = +-31.7 is less than h_R
#include "exact/exact_predicates.hpp"

#include "exact/discriminant.hpp"
#include "exact/power.hpp"

namespace hsp::exact {
namespace {

template <class Limb>
struct Evaluation {
  using I64 = WideInteger<Limb, 64>;
  using I128 = WideInteger<Limb, 128>;
  using I192 = WideInteger<Limb, 192>;
  using I256 = WideInteger<Limb, 256>;

  // A vector of 128-bit components (q or H).
  struct LongVector {
    I128 x, y, z;
  };

  // Out of line, as Growth::sign() is: most calls are for ties.
  [[gnu::noinline]] static I192 dot192(const LongVector &a, const Vector &b) {
    return product<192>(a.x, I64::from(b.x)) + product<192>(a.y, I64::from(b.y)) + product<192>(a.z, I64::from(b.z));
  }
  template <int bits>
  static WideInteger<Limb, bits> square(const LongVector &a) {
    return product<bits>(a.x, a.x) + product<bits>(a.y, a.y) + product<bits>(a.z, a.z);
  }

  static LongVector q_of(const Plane &P, const Plane &Q) {
    return {times<Limb>(P.h, Q.v.x) - times<Limb>(Q.h, P.v.x), times<Limb>(P.h, Q.v.y) - times<Limb>(Q.h, P.v.y),
            times<Limb>(P.h, Q.v.z) - times<Limb>(Q.h, P.v.z)};
  }
  static I192 D_of(const Sphere &sphere, const Vector &n, const LongVector &q) {
    return product<192>(dot128<Limb>(n, n), I64::from(sphere.W)) - square<192>(q);
  }
  // Out of line, too: it is needed only where doubles are not certain about a vertex.
  [[gnu::noinline]] static LongVector H_of(const Plane &P, const Plane &Q, const Plane &R, const Vector &n) {
    const LongVector q = q_of(P, Q);
    const Vector &z = R.v;
    const auto minor = [](const I128 &a, int64_t b, const I128 &c, int64_t d) {
      return product<128>(a, I64::from(b)) - product<128>(c, I64::from(d));
    };
    return {minor(q.y, z.z, q.z, z.y) + times<Limb>(R.h, n.x), minor(q.z, z.x, q.x, z.z) + times<Limb>(R.h, n.y),
            minor(q.x, z.y, q.y, z.x) + times<Limb>(R.h, n.z)};
  }
  static I256 F_of(const Sphere &sphere, const LongVector &H, const I128 &B) {
    return product<256>(product<192>(B, B), I64::from(sphere.W)) - square<256>(H);
  }
};

// The changes of a predicate as the balls in it grow, up to one positive factor.
template <class Limb>
class Growth {
 public:
  using I128 = WideInteger<Limb, 128>;
  using I192 = WideInteger<Limb, 192>;

  // alike: the change if all balls grow by the same amount.
  Growth(const Sphere &sphere, const I192 &alike)
      : origin_(origin_plane(sphere)), weight_(sphere.W / 4), ball_{&origin_}, change_{alike} {}
  // change: if the ball of this plane grows alone. A virtual plane does not grow. Out of line, as sign() is.
  [[gnu::noinline]] void add(const Plane &plane, const I192 &change) {
    if (plane.perturbed == 0) {
      balls_alone_ = false;
      return;
    }
    ball_[balls_] = &plane;
    change_[balls_++] = change;
    change_[0] = change_[0] - change;
  }

  // The sign of the change if balls grow by the amounts of a level. Out of line: all predicates call it, in several
  // places.
  [[gnu::noinline]] int sign(int level) const {
    return level == levels - 1 ? sign_of_sum([](const Plane &ball) { return last_amount<Limb>(ball.v); })
                               : sign_of_sum([&](const Plane &ball) { return amount(level, ball); });
  }
  // The sign of the change at the first level where it is not 0: this decides predicates that are linear in the
  // weights. Without virtual planes the sums with 1, x, y and z are 0.
  int sign() const {
    for (int level = 0; level < levels; level += level == 0 && balls_alone_ ? levels - 1 : 1) {
      if (const int of_level = sign(level); of_level != 0) return of_level;
    }
    int first = -1;
    for (int k = 0; k < balls_; ++k) {
      if (change_[k].sign() != 0 && (first < 0 || ranks_before(*ball_[k], *ball_[first]))) first = k;
    }
    return first < 0 ? 0 : change_[first].sign();
  }

 private:
  static constexpr int levels = 6;

  template <class AmountOf>
  int sign_of_sum(AmountOf amount_of) const {
    WideInteger<Limb, 256> sum{};
    for (int k = 0; k < balls_; ++k) sum = sum + product<256>(change_[k], amount_of(*ball_[k]));
    return sum.sign();
  }

  // The amounts of the levels: the weight; 1; the centre's coordinates; a quadratic form of the centre. Coordinates are
  // relative to the origin ball: if the sums of the levels before are 0, other origins give the same sums.
  WideInteger<Limb, 64> amount(int level, const Plane &ball) const {
    const int64_t amounts[] = {weight_ + dot(ball.v, ball.v) - ball.h, 1, ball.v.x, ball.v.y, ball.v.z};
    return WideInteger<Limb, 64>::from(amounts[level]);
  }

  Plane origin_;
  int64_t weight_;
  const Plane *ball_[5];
  I192 change_[5];
  int balls_ = 1;
  bool balls_alone_ = true;
};

template <class Limb>
WideInteger<Limb, 192> to_192_bits(const WideInteger<Limb, 128> &value) {
  return product<192>(value, WideInteger<Limb, 64>::from(1));
}
// The change as a ball grows; it is needed for ties alone.
template <class Limb>
[[gnu::noinline]] WideInteger<Limb, 192> rate(const Vector &a, const Vector &b) {
  return to_192_bits(dot128<Limb>(a, b));
}

}  // namespace

template <class Limb>
Sign ExactPredicates<Limb>::crossing(const Sphere &sphere, const Plane &P, const Plane &Q) {
  using E = Evaluation<Limb>;
  const Vector n = cross(P.v, Q.v);
  // Parallel planes: D = -|h_P v - h_Q u|^2 stays negative under the perturbation (PROOFS.md, section 3).
  if (is_zero(n)) return {-1, false};
  const auto q = E::q_of(P, Q);
  const int value = E::D_of(sphere, n, q).sign();
  if (value != 0) return {value, false};

  // Half of dD/dw: alpha = q.v for P, beta = -q.u for Q, 2N if all grow alike.
  Growth<Limb> growth(sphere, product<192>(dot128<Limb>(n, n), E::I64::from(2)));
  growth.add(P, E::dot192(q, Q.v));
  growth.add(Q, -E::dot192(q, P.v));
  const int derivative = growth.sign(0);
  return {derivative != 0 ? derivative : -1, true};
}

template <class Limb>
Sign ExactPredicates<Limb>::side(const Sphere &sphere, const Plane &P, const Plane &R) {
  // beta = h_R u.u - h_P u.z < 0 iff the centre of circle P lies inside R.
  const int64_t uu = dot(P.v, P.v);
  const int64_t uz = dot(P.v, R.v);
  const int value = (times<Limb>(R.h, uu) - times<Limb>(P.h, uz)).sign();
  if (value != 0) return {-value, false};
  Growth<Limb> growth(sphere, {});
  growth.add(P, to_192_bits(times<Limb>(uz, 1)));
  growth.add(R, -to_192_bits(times<Limb>(uu, 1)));
  return {-growth.sign(), true};
}

template <class Limb>
PointStatus ExactPredicates<Limb>::point_status(const Sphere &sphere, const Plane &P, const Plane &Q, const Plane &R) {
  using E = Evaluation<Limb>;
  const Vector n = cross(P.v, Q.v);
  const auto H = E::H_of(P, Q, R, n);
  const auto B = dot128<Limb>(n, R.v);
  const int sign_B = B.sign();
  const Vector qr = cross(Q.v, R.v);
  const Vector rp = cross(R.v, P.v);

  const int value_A = -E::dot192(H, n).sign();
  // If the four centres are coplanar, B is 0 and both points are on the same side of R.
  bool tied[2] = {value_A == 0, value_A == 0};
  if (sign_B != 0) {
    int sign_F = E::F_of(sphere, H, B).sign();
    tied[0] = tied[1] = false;
    if (sign_F == 0) {
      // A^2 = B^2 D: the point with A + s B sqrt(D) = 0 lies on R; if the points coincide, both do.
      const int on = -value_A * sign_B;
      tied[0] = on <= 0;
      tied[1] = on >= 0;
      const auto square = product<192>(B, B);
      Growth<Limb> growth(sphere, square + square);
      growth.add(P, E::dot192(H, qr));
      growth.add(Q, E::dot192(H, rp));
      growth.add(R, E::dot192(H, n));
      sign_F = growth.sign(0);
      if (sign_F == 0) sign_F = -1;
    }
    if (sign_F > 0) return {{-sign_B, sign_B}, {tied[0], tied[1]}};
  }
  int side = value_A;
  if (side == 0) {  // A = -H.n changes by (v x z).n with P, (z x u).n with Q and N > 0 with R
    Growth<Limb> growth(sphere, {});
    growth.add(P, rate<Limb>(qr, n));
    growth.add(Q, rate<Limb>(rp, n));
    growth.add(R, rate<Limb>(n, n));
    side = growth.sign();
  }
  return {{side, side}, {tied[0], tied[1]}};
}

// Cold, so that it is small: it is asked for contacts, and for dense sets whose vertices tie.
template <class Limb>
[[gnu::cold]] Sign ExactPredicates<Limb>::near(const Sphere &sphere, const Plane &P, const Plane &Q, const Plane &R,
                                               const Plane &S) {
  using E = Evaluation<Limb>;
  const Vector n = cross(P.v, Q.v);
  const auto H = E::H_of(P, Q, R, n);
  const auto B = dot128<Limb>(n, R.v);
  const int sign_B = B.sign();
  const int value = (product<192>(B, E::I64::from(S.h)) - E::dot192(H, S.v)).sign();
  if (value != 0) return {value * sign_B, false};
  Growth<Limb> growth(sphere, {});
  growth.add(P, rate<Limb>(cross(Q.v, R.v), S.v));
  growth.add(Q, rate<Limb>(cross(R.v, P.v), S.v));
  growth.add(R, rate<Limb>(n, S.v));
  growth.add(S, -to_192_bits(B));
  return {growth.sign() > 0 ? sign_B : -sign_B, true};
}

template <class Limb>
double ExactPredicates<Limb>::discriminant(const Sphere &sphere, const Plane &P, const Plane &Q) {
  using E = Evaluation<Limb>;
  const double D = E::D_of(sphere, cross(P.v, Q.v), E::q_of(P, Q)).to_double();
  return D > 0.0 ? D : 0.0;  // at a tie the perturbed discriminant is infinitesimal
}

template <class Limb>
double ExactPredicates<Limb>::radical_coordinate(const Plane &P, const Plane &R) {
  return (times<Limb>(R.h, dot(P.v, P.v)) - times<Limb>(P.h, dot(P.v, R.v))).to_double();
}

template <class Limb>
double ExactPredicates<Limb>::circle_discriminant(const Sphere &sphere, const Plane &P) {
  return (times<Limb>(sphere.W, dot(P.v, P.v)) - times<Limb>(P.h, P.h)).to_double();
}

template <class Limb>
double ExactPredicates<Limb>::exterior_cosine(const Sphere &sphere, const Plane &P, const Plane &Q) {
  return (times<Limb>(sphere.W, dot(P.v, Q.v)) - times<Limb>(P.h, Q.h)).to_double();
}

template <class Limb>
double ExactPredicates<Limb>::triple_product(const Vector &u, const Vector &v, const Vector &z) {
  return dot128<Limb>(cross(u, v), z).to_double();
}

template <class Limb>
int ExactPredicates<Limb>::triple_product_sign(const Vector &u, const Vector &v, const Vector &z) {
  return dot128<Limb>(cross(u, v), z).sign();
}

template <class Limb>
double ExactPredicates<Limb>::cross_dot_cross(const Vector &u, const Vector &v, const Vector &z) {
  return dot128<Limb>(cross(u, v), cross(u, z)).to_double();
}

template <class Limb>
int ExactPredicates<Limb>::cross_dot_cross_sign(const Vector &u, const Vector &v, const Vector &z) {
  return dot128<Limb>(cross(u, v), cross(u, z)).sign();
}

// Cold: for vertices and arcs that doubles do not serve.
template <class Limb>
[[gnu::cold]] void ExactPredicates<Limb>::radical_vector(const Plane &P, const Plane &Q, double q[3]) {
  const auto exact_q = Evaluation<Limb>::q_of(P, Q);
  q[0] = exact_q.x.to_double();
  q[1] = exact_q.y.to_double();
  q[2] = exact_q.z.to_double();
}

template struct ExactPredicates<FastLimb>;

}  // namespace hsp::exact
