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

#include "exact/chord_line.hpp"

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

  static I128 times(int64_t a, int64_t b) { return product<128>(I64::from(a), I64::from(b)); }
  static I128 dot128(const Vector &a, const Vector &b) { return times(a.x, b.x) + times(a.y, b.y) + times(a.z, b.z); }
  template <int bits>
  static WideInteger<Limb, bits> dot_long(const LongVector &a, const Vector &b) {
    return product<bits>(a.x, I64::from(b.x)) + product<bits>(a.y, I64::from(b.y)) + product<bits>(a.z, I64::from(b.z));
  }
  template <int bits>
  static WideInteger<Limb, bits> square(const LongVector &a) {
    return product<bits>(a.x, a.x) + product<bits>(a.y, a.y) + product<bits>(a.z, a.z);
  }

  static LongVector q_of(const Plane &P, const Plane &Q) {
    return {times(P.h, Q.v.x) - times(Q.h, P.v.x), times(P.h, Q.v.y) - times(Q.h, P.v.y),
            times(P.h, Q.v.z) - times(Q.h, P.v.z)};
  }
  static I192 D_of(const Sphere &sphere, const Vector &n, const LongVector &q) {
    return product<192>(dot128(n, n), I64::from(sphere.W)) - square<192>(q);
  }
  static LongVector H_of(const Plane &P, const Plane &Q, const Plane &R, const Vector &n) {
    const LongVector q = q_of(P, Q);
    const Vector &z = R.v;
    const auto minor = [](const I128 &a, int64_t b, const I128 &c, int64_t d) {
      return product<128>(a, I64::from(b)) - product<128>(c, I64::from(d));
    };
    return {minor(q.y, z.z, q.z, z.y) + times(R.h, n.x), minor(q.z, z.x, q.x, z.z) + times(R.h, n.y),
            minor(q.x, z.y, q.y, z.x) + times(R.h, n.z)};
  }
  static I256 F_of(const Sphere &sphere, const LongVector &H, const I128 &B) {
    return product<256>(product<192>(B, B), I64::from(sphere.W)) - square<256>(H);
  }
};

enum class Owner { origin, P, Q, R };

// The ball of lowest rank among the origin and up to three planes.
Owner lowest(const Sphere &sphere, const Plane &P, const Plane &Q, const Plane *R) {
  Owner owner = Owner::origin;
  Plane best = origin_plane(sphere);
  if (ranks_before(P, best)) {
    owner = Owner::P;
    best = P;
  }
  if (ranks_before(Q, best)) {
    owner = Owner::Q;
    best = Q;
  }
  if (R != nullptr && ranks_before(*R, best)) owner = Owner::R;
  return owner;
}

// The first non-zero coefficient in the order of ranks. It decides the linear predicates, side and A, where their value
// is 0.
struct Term {
  Plane rank;
  int coefficient;
};
template <int count>
int first_in_rank(const Term (&terms)[count]) {
  int best = -1;
  for (int k = 0; k < count; ++k) {
    if (terms[k].coefficient != 0 && (best < 0 || ranks_before(terms[k].rank, terms[best].rank))) best = k;
  }
  return best < 0 ? 0 : terms[best].coefficient;
}

int sign_of(int64_t value) {
  return (value > 0) - (value < 0);
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

  // Half of dD/dw: alpha = q.v for P, beta = -q.u for Q, and for the origin 2N less alpha and beta, each only if its
  // plane is that of a ball.
  const auto alpha = E::template dot_long<128>(q, Q.v);
  const auto minus_beta = E::template dot_long<128>(q, P.v);
  int derivative = 0;
  switch (lowest(sphere, P, Q, nullptr)) {
    case Owner::P:
      derivative = alpha.sign();
      break;
    case Owner::Q:
      derivative = -minus_beta.sign();
      break;
    default: {
      const auto N = E::dot128(n, n);
      auto sum = N + N;
      if (P.perturbed != 0) sum = sum - alpha;
      if (Q.perturbed != 0) sum = sum + minus_beta;
      derivative = sum.sign();
    }
  }
  return {derivative != 0 ? derivative : -1, true};
}

template <class Limb>
Sign ExactPredicates<Limb>::side(const Sphere &sphere, const Plane &P, const Plane &R) {
  using E = Evaluation<Limb>;
  // beta = h_R u.u - h_P u.z < 0 iff the centre of circle P lies inside R.
  const int64_t uu = dot(P.v, P.v);
  const int64_t uz = dot(P.v, R.v);
  const int value = (E::times(R.h, uu) - E::times(P.h, uz)).sign();
  if (value != 0) return {-value, false};
  const Term terms[] = {
      {origin_plane(sphere), sign_of(R.perturbed * uu - P.perturbed * uz)}, {R, -1}, {P, sign_of(uz)}};
  return {-first_in_rank(terms), true};
}

template <class Limb>
PointStatus ExactPredicates<Limb>::point_status(const Sphere &sphere, const Plane &P, const Plane &Q, const Plane &R) {
  using E = Evaluation<Limb>;
  const Vector n = cross(P.v, Q.v);
  const auto H = E::H_of(P, Q, R, n);
  const auto B = E::dot128(n, R.v);
  const int sign_B = B.sign();
  const Vector qr = cross(Q.v, R.v);
  const Vector rp = cross(R.v, P.v);

  // A = -H.n, its perturbation in rank order: origin -T.n, P (v x z).n, Q (z x u).n, R +N > 0.
  const int value_A = -E::template dot_long<192>(H, n).sign();
  const auto perturbed_A = [&]() {
    if (value_A != 0) return value_A;
    const auto a = E::dot128(qr, n);
    const auto b = E::dot128(rp, n);
    auto minus_T_n = WideInteger<Limb, 128>{};
    if (P.perturbed != 0) minus_T_n = minus_T_n - a;
    if (Q.perturbed != 0) minus_T_n = minus_T_n - b;
    if (R.perturbed != 0) minus_T_n = minus_T_n - E::dot128(n, n);
    const Term terms[] = {{origin_plane(sphere), minus_T_n.sign()}, {P, a.sign()}, {Q, b.sign()}, {R, 1}};
    return first_in_rank(terms);
  };
  if (sign_B == 0) {  // four coplanar centres: both points are on the same side of R
    const int side = perturbed_A();
    return {{side, side}, {value_A == 0, value_A == 0}};
  }

  const int value_F = E::F_of(sphere, H, B).sign();
  int sign_F = value_F;
  bool tied[2] = {false, false};
  if (value_F == 0) {
    // A^2 = B^2 D: the point with A + s B sqrt(D) = 0 lies on R, both do if they coincide.
    const int on = -value_A * sign_B;
    tied[0] = on <= 0;
    tied[1] = on >= 0;
    switch (lowest(sphere, P, Q, &R)) {
      case Owner::P:
        sign_F = E::template dot_long<192>(H, qr).sign();
        break;
      case Owner::Q:
        sign_F = E::template dot_long<192>(H, rp).sign();
        break;
      case Owner::R:
        sign_F = E::template dot_long<192>(H, n).sign();
        break;
      default: {
        const auto square = product<192>(B, B);
        auto sum = square + square;
        if (P.perturbed != 0) sum = sum - E::template dot_long<192>(H, qr);
        if (Q.perturbed != 0) sum = sum - E::template dot_long<192>(H, rp);
        if (R.perturbed != 0) sum = sum - E::template dot_long<192>(H, n);
        sign_F = sum.sign();
      }
    }
    if (sign_F == 0) sign_F = -1;
  }
  if (sign_F > 0) return {{-sign_B, sign_B}, {tied[0], tied[1]}};
  const int side = perturbed_A();
  return {{side, side}, {tied[0], tied[1]}};
}

template <class Limb>
Sign ExactPredicates<Limb>::near(const Sphere &sphere, const Plane &P, const Plane &Q, const Plane &R, const Plane &S) {
  using E = Evaluation<Limb>;
  const Vector n = cross(P.v, Q.v);
  const auto H = E::H_of(P, Q, R, n);
  const auto B = E::dot128(n, R.v);
  const int sign_B = B.sign();
  const int value = (product<192>(B, E::I64::from(S.h)) - E::template dot_long<192>(H, S.v)).sign();
  if (value != 0) return {value * sign_B, false};
  // The origin's coefficient is minus the sum of the others.
  const auto a = E::dot128(cross(Q.v, R.v), S.v);
  const auto b = E::dot128(cross(R.v, P.v), S.v);
  const auto c = E::dot128(n, S.v);
  const Term terms[] = {
      {origin_plane(sphere), (B - a - b - c).sign()}, {P, a.sign()}, {Q, b.sign()}, {R, c.sign()}, {S, -sign_B}};
  return {first_in_rank(terms) > 0 ? sign_B : -sign_B, true};
}

template <class Limb>
double ExactPredicates<Limb>::discriminant(const Sphere &sphere, const Plane &P, const Plane &Q) {
  using E = Evaluation<Limb>;
  const double D = E::D_of(sphere, cross(P.v, Q.v), E::q_of(P, Q)).to_double();
  return D > 0.0 ? D : 0.0;  // at a tie the perturbed discriminant is infinitesimal
}

template <class Limb>
double ExactPredicates<Limb>::radical_coordinate(const Plane &P, const Plane &R) {
  using E = Evaluation<Limb>;
  return (E::times(R.h, dot(P.v, P.v)) - E::times(P.h, dot(P.v, R.v))).to_double();
}

template <class Limb>
double ExactPredicates<Limb>::circle_discriminant(const Sphere &sphere, const Plane &P) {
  using E = Evaluation<Limb>;
  return (E::times(sphere.W, dot(P.v, P.v)) - E::times(P.h, P.h)).to_double();
}

template <class Limb>
double ExactPredicates<Limb>::exterior_cosine(const Sphere &sphere, const Plane &P, const Plane &Q) {
  using E = Evaluation<Limb>;
  return (E::times(sphere.W, dot(P.v, Q.v)) - E::times(P.h, Q.h)).to_double();
}

template <class Limb>
double ExactPredicates<Limb>::triple_product(const Vector &u, const Vector &v, const Vector &z) {
  return Evaluation<Limb>::dot128(cross(u, v), z).to_double();
}

template <class Limb>
int ExactPredicates<Limb>::triple_product_sign(const Vector &u, const Vector &v, const Vector &z) {
  return Evaluation<Limb>::dot128(cross(u, v), z).sign();
}

template <class Limb>
double ExactPredicates<Limb>::cross_dot_cross(const Vector &u, const Vector &v, const Vector &z) {
  return Evaluation<Limb>::dot128(cross(u, v), cross(u, z)).to_double();
}

template <class Limb>
int ExactPredicates<Limb>::cross_dot_cross_sign(const Vector &u, const Vector &v, const Vector &z) {
  return Evaluation<Limb>::dot128(cross(u, v), cross(u, z)).sign();
}

template <class Limb>
ChordFactors ExactPredicates<Limb>::chord_factors(const Plane &P, const Plane &Q) {
  return ChordLine<Limb>(P, Q).factors();
}

template <class Limb>
double ExactPredicates<Limb>::line_parameter(const Plane &P, const Plane &Q, const Plane &R) {
  return ChordLine<Limb>(P, Q).parameter(R);
}

template <class Limb>
void ExactPredicates<Limb>::radical_vector(const Plane &P, const Plane &Q, double q[3]) {
  const auto exact_q = Evaluation<Limb>::q_of(P, Q);
  q[0] = exact_q.x.to_double();
  q[1] = exact_q.y.to_double();
  q[2] = exact_q.z.to_double();
}

template struct ExactPredicates<FastLimb>;

}  // namespace hsp::exact
