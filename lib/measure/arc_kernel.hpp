// The kernels of arc_sums.hpp for registers of n doubles. arc_kernel.cpp and arc_kernel_avx2.cpp compile them; like
// everything in files for AVX2 they have internal linkage.
#pragma once

#include "core/elementary.hpp"
#include "exact/circle_crossing.hpp"
#include "measure/arc_sums.hpp"
#include "measure/exterior_angles.hpp"

namespace hsp {
namespace {

// Doubles serve well-conditioned circles, rho^2 >= r^2/64 and d <= 4 r, and well-conditioned vertices, those of two
// such circles whose axes have an angle of sine s with s^2 >= 1/16. To first order, in units of e = 2^-53, with sigma =
// rho/r, and v = d u exact:
//   u               |v|^2 3, root 2.5, inverse 3.5, product                                         4.5
//   H = 2 h d       4 d^2 + 2 * 2 |h| d                                                              20 r d
//   2 h             H/d + 4.5 * 2 |h|                                                                29 r
//   n = v x v'      over d d'                                                                        3
//   q = H v' - H' v over d d': 2 (20 r + 2 r) + |q|, and |q| <= 2 r s                                46 r
//   vertex          q 46/s, n 6/s twice, n.n 12/s + 8, root and roundings 16 r; |vertex| = 2 r      304 r
//   from the circle's centre, 2 rho away: 304 r + 29 r + 11 r + 2 r, as an angle                    180/sigma
//   angle of an arc both ends, and 50 for x, y and the arc tangent                                  410/sigma
//   exterior angle  (u.u' 3, h h'/r^2 23) over sigma sigma'                                          30/(sigma sigma')
// so the error is below 2^-44/sigma, and typically some e/sigma: n, q and H are exact in molecules. This is negligible
// against branch_cut_margin: arcs at least that far from 0 and 2 pi are classified correctly.
constexpr double least_square_of_radius = 1.0 / 64;
constexpr double most_square_of_distance = 16.0;
constexpr double least_square_of_sine = 1.0 / 16;

double sum_of_lanes(const double (&lanes)[sum_lanes]) {
  return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
}

template <uint32_t n>
struct ArcKernel {
  using L = DoubleLanes<n>;
  using Real = typename L::Real;
  using Mask = typename L::Mask;
  using Vector = VectorOf<Real>;

  static Vector load(const double *x, const double *y, const double *z, uint32_t s) {
    return {L::load(x + s), L::load(y + s), L::load(z + s)};
  }
  static Vector gather(const double *x, const double *y, const double *z, const uint32_t *index) {
    return {L::gather(x, index), L::gather(y, index), L::gather(z, index)};
  }
  static void store(double *x, double *y, double *z, uint32_t s, const Vector &a) {
    L::store(x + s, a.x);
    L::store(y + s, a.y);
    L::store(z + s, a.z);
  }
  static Vector kept(const Mask &mask, const Vector &a) {
    return {L::kept(mask, a.x), L::kept(mask, a.y), L::kept(mask, a.z)};
  }
  static Vector axes(const ArcBatch &b, uint32_t s) { return load(b.ux, b.uy, b.uz, s); }

  // Returns the mask of those that doubles do not serve.
  [[gnu::always_inline]] static Mask evaluate_circles(const BallOfSet &ball, ArcBatch &b) {
    const double inverse_diameter = ball.r > 0.0 ? 0.5 / ball.r : 0.0;
    const double most_U = most_square_of_distance * ball.r * ball.r;
    Mask unserved{};
    for (uint32_t s = 0; s < b.count; s += n) {
      const uint32_t *const other = b.other + s;
      const Vector centre = gather(ball.xs, ball.ys, ball.zs, other);
      const Vector v{centre.x - ball.x, centre.y - ball.y, centre.z - ball.z};
      const Real other_radius = L::gather(ball.rs, other);
      const Real U = dot(v, v);
      const Real inverse = 1.0 / L::square_root(U);
      const Real scaled_height = U + (ball.r - other_radius) * (ball.r + other_radius);
      const Real twice_height = scaled_height * inverse;
      const Real cosine = twice_height * inverse_diameter;
      const Mask served = L::both((1.0 - cosine) * (1.0 + cosine) >= least_square_of_radius, U <= most_U);
      store(b.vx, b.vy, b.vz, s, v);
      L::store(b.square_of_distance + s, L::valid(served, U));
      L::store(b.scaled_height + s, scaled_height);
      store(b.ux, b.uy, b.uz, s, inverse * v);
      L::store(b.inverse_distance + s, inverse);
      L::store(b.twice_height + s, L::valid(served, twice_height));
      unserved |= ~served;
    }
    return unserved;
  }

  // A loop comes in along the circle v, H = 2 h d and leaves along v', H'. With n = v x v' and q = H v' - H' v twice
  // the vertex is (q x n + sqrt(D) n)/n.n, where q is orthogonal to n, so that q x n has no cancellation; and the loop
  // turns there by the angle of (4 r^2 v.v' - H H', 2 r sqrt(D)).
  static void evaluate_vertices(double radius, ArcBatch &b) {
    const double diameter = 2 * radius;
    const double square = diameter * diameter;
    static_assert(ArcBatch::capacity / sum_lanes <= ExteriorAngleSum<n>::most_directions);
    double angles[sum_lanes] = {};
    Mask turns{};
    for (uint32_t lane = 0; lane < sum_lanes && lane < b.count; lane += n) {
      ExteriorAngleSum<n> sum;
      for (uint32_t s = lane; s < b.count; s += sum_lanes) {
        const uint32_t *const before = b.previous + s;
        const Vector v_in = gather(b.vx, b.vy, b.vz, before);
        const Vector v_out = load(b.vx, b.vy, b.vz, s);
        const Real H_in = L::gather(b.scaled_height, before);
        const Real H_out = L::load(b.scaled_height + s);
        const Real root = L::load(b.root_discriminant + s);
        const Real UU = L::gather(b.square_of_distance, before) * L::load(b.square_of_distance + s);
        const CircleCrossing<Vector, Real> crossing(v_in, H_in, v_out, H_out);
        const Real cosine = square * dot(v_in, v_out) - H_in * H_out;
        const Mask served = crossing.nn >= least_square_of_sine * UU;
        store(b.px, b.py, b.pz, s, crossing.point(L::valid(served, root)));
        const Mask counted = served & L::load_mask(b.arc + s);
        sum.add_directions(L::select(counted, cosine, L::all(1.0)), L::kept(counted, diameter * root));
      }
      L::store(angles + lane, sum.angles());
      turns += sum.turns();
    }
    b.exterior_turns = static_cast<double>(L::sum(turns));
    b.exterior_angles = sum_of_lanes(angles);
  }

  // Returns the mask of those that doubles do not serve.
  [[gnu::always_inline]] static Mask evaluate_arcs(ArcBatch &b) {
    Mask unserved{};
    for (uint32_t s = 0; s < b.count; s += n) {
      const Vector u = axes(b, s);
      const Vector from = load(b.px, b.py, b.pz, s);
      const Vector to = gather(b.px, b.py, b.pz, b.next + s);
      // The loop runs clockwise, from q to p.
      const Vector centre = L::load(b.twice_height + s) * u;
      const Vector p = to - centre;
      const Vector q = from - centre;
      const Vector X = cross(from - to, u);
      const Real x = dot(p, q);
      const Real y = dot(p, X);  // u.(p x q)
      const Mask arc = L::load_mask(b.arc + s);
      const Mask served = L::both(L::absolute(y) >= branch_cut_margin * x, arc);
      const Mask not_served = arc & ~served;
      L::store(b.angle + s, L::number(L::bits(L::kept(served, turn_angle<n>(x, y))) | not_served));
      store(b.Xx, b.Xy, b.Xz, s, kept(served, X));
      unserved |= not_served;
    }
    return unserved;
  }

  static bool evaluate(const BallOfSet &ball, ArcBatch &b) {
    const Mask circles = evaluate_circles(ball, b);
    evaluate_vertices(ball.r, b);
    const Mask arcs = evaluate_arcs(b);
    return !L::any(circles | arcs);
  }

  // With m = h u and X = 2 (q - p) x u: cos(cap) = h/r, m x (q - p) = -h X / 2, rho^2 = (r - h)(r + h).
  static AreaSums sum_areas(const ArcBatch &b, double radius) {
    const double diameter = 2 * radius;
    double cosines[sum_lanes], x[sum_lanes], y[sum_lanes], z[sum_lanes];
    for (uint32_t lane = 0; lane < sum_lanes; lane += n) {
      Real cosine = L::all(0.0);
      Vector area{L::all(0.0), L::all(0.0), L::all(0.0)};
      for (uint32_t s = lane; s < b.count; s += sum_lanes) {
        const Real height = L::load(b.twice_height + s);
        const Real angle = L::load(b.angle + s);
        const Real along = (diameter - height) * (diameter + height) * angle;
        cosine += height * angle;
        area = area + (height * load(b.Xx, b.Xy, b.Xz, s) - along * axes(b, s));
      }
      L::store(cosines + lane, cosine);
      store(x, y, z, lane, area);
    }
    return {sum_of_lanes(cosines), {sum_of_lanes(x), sum_of_lanes(y), sum_of_lanes(z)}};
  }

  // With s the weights, ball k's own area and those of its neighbours give together, per arc,
  //   dS/dc_k: u phi [ -s_k R_k (1 - h/d) - s_j R_j h/d ] + (q - p) x u [ s_k R_k - s_j R_j ]/d
  //   dS/dR_k: s_k phi (R_k^2/d - h) - s_j R_j R_k phi / d,   as (R_k^2 + R_j^2 - d^2)/(2 d) = R_k^2/d - h
  // The term with the factor s_k R_k - s_j R_j vanishes for equal balls. A sphere with R_k = 0 has only infinitely
  // short arcs, and every term is 0.
  static WeightedSums sum_weighted(const ArcBatch &b, double radius, double weight) {
    const double own = weight * radius;
    double by_radius[sum_lanes], x[sum_lanes], y[sum_lanes], z[sum_lanes];
    for (uint32_t lane = 0; lane < sum_lanes; lane += n) {
      Real sum = L::all(0.0);
      Vector centre{L::all(0.0), L::all(0.0), L::all(0.0)};
      for (uint32_t s = lane; s < b.count; s += sum_lanes) {
        const Real half = 0.5 * (own - L::load(b.other_weight + s)) * L::load(b.inverse_distance + s);
        const Real height = L::load(b.twice_height + s);
        const Real angle = L::load(b.angle + s);
        centre = centre + (angle * (half * height - own) * axes(b, s) + half * load(b.Xx, b.Xy, b.Xz, s));
        sum += angle * (2 * radius * half - 0.5 * weight * height);
      }
      L::store(by_radius + lane, sum);
      store(x, y, z, lane, centre);
    }
    return {{sum_of_lanes(x), sum_of_lanes(y), sum_of_lanes(z)}, sum_of_lanes(by_radius)};
  }
};

}  // namespace
}  // namespace hsp
