// The kernels of arc_sums.hpp for registers of n doubles. Like everything in kernels they have internal linkage.
//
// As an example two balls of radius 5 whose centres are 8 apart: d = 8, |v|^2 = 64, and the plane of their circle is at
//   h = (64 + 25 - 25) / (2 * 8) = 4        rho^2 = 25 - 16 = 9
// The whole circle is free: its angle is 2 pi, and there are no vertices. Its term in area / r^2 is cos(cap) angle =
// 4/5 * 2 pi. With one face and one loop, area / r^2 = 2 pi (2 - 1) + 8/5 pi = 18/5 pi. So the area is 90 pi: the
// sphere's 100 pi less the cap's 2 pi r (r - h) = 10 pi.
#pragma once

#include "core/elementary.hpp"
#include "core/small_code.hpp"
#include "exact/circle_crossing.hpp"
#include "measure/arc_sums.hpp"
#include "measure/exterior_angles.hpp"
#include "measure/lane_sums.hpp"

namespace hsp {
namespace {

// Doubles are used for well-conditioned circles, with rho^2 >= r^2/64 and d <= 4 r, and for well-conditioned vertices:
// those of two such circles whose axes have an angle of sine s with s^2 >= 1/16. Errors, to first order, in units of
// e = 2^-53, with sigma = rho/r, and v = d u exact:
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

template <uint32_t n>
struct ArcKernel {
  using L = Wide<double, n>;
  using Real = typename L::Real;
  using Mask = typename L::Mask;
  using Vector = VectorOf<Real>;
  using Sums = FourSums<n>;

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

  // Returns the mask of the circles that doubles do not serve.
  [[gnu::always_inline]] static Mask evaluate_circles(const BallOfSet &ball, ArcBatch &batch) {
    const double inverse_diameter = ball.r > 0.0 ? 0.5 / ball.r : 0.0;
    const double most_U = most_square_of_distance * ball.r * ball.r;
    Mask unserved{};
    for (uint32_t s = 0; s < batch.count; s += n) {
      ArcBatch &b = by_one_register(batch);
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
      L::store(b.other_radius + s, other_radius);
      if (b.products != nullptr) L::store(b.products->square + s, U);
      L::store(b.square_of_distance + s, L::valid(served, U));
      L::store(b.scaled_height + s, scaled_height);
      store(b.ux, b.uy, b.uz, s, inverse * v);
      L::store(b.inverse_distance + s, inverse);
      L::store(b.twice_height + s, L::valid(served, twice_height));
      unserved |= ~served;
    }
    return unserved;
  }

  // A loop arrives along the circle with v and H = 2 h d, and leaves along the circle with v' and H'. With n = v x v'
  // and q = H v' - H' v, twice the vertex is (q x n + sqrt(D) n)/n.n; q is orthogonal to n, so that q x n has no
  // cancellation. There the loop turns by the angle of the direction (4 r^2 v.v' - H H', 2 r sqrt(D)).
  static void evaluate_vertices(double radius, ArcBatch &batch) {
    const double diameter = 2 * radius;
    const double square = diameter * diameter;
    static_assert(ArcBatch::capacity / sum_lanes <= ExteriorAngleSum<n>::most_directions);
    double angles[sum_lanes] = {};
    Mask turns{};
    for (uint32_t lane = 0; lane < sum_lanes && lane < batch.count; lane += n) {
      ExteriorAngleSum<n> sum;
      for (uint32_t s = lane; s < batch.count; s += sum_lanes) {
        ArcBatch &b = by_one_register(batch);
        const uint32_t *const before = b.previous + s;
        const Vector v_in = gather(b.vx, b.vy, b.vz, before);
        const Vector v_out = load(b.vx, b.vy, b.vz, s);
        const Real product = dot(v_in, v_out);
        L::store(b.product_with_previous + s, product);
        const Real H_in = L::gather(b.scaled_height, before);
        const Real H_out = L::load(b.scaled_height + s);
        const Real root = L::load(b.root_discriminant + s);
        const Real UU = L::gather(b.square_of_distance, before) * L::load(b.square_of_distance + s);
        const CircleCrossing<Vector, Real> crossing(v_in, H_in, v_out, H_out);
        if (b.products != nullptr) L::store(b.products->square_of_normal + s, crossing.nn);
        const Real cosine = square * product - H_in * H_out;
        const Mask served = crossing.nn >= least_square_of_sine * UU;
        store(b.px, b.py, b.pz, s, crossing.point(L::valid(served, root)));
        const Mask counted = served & L::load_mask(b.arc + s);
        sum.add_directions(L::select(counted, cosine, L::all(1.0)), L::kept(counted, diameter * root));
      }
      L::store(angles + lane, sum.angles());
      turns += sum.turns();
    }
    batch.exterior_turns = static_cast<double>(L::sum(turns));
    batch.exterior_angles = sum_of_lanes(angles);
  }

  // Returns the mask of the arcs that doubles do not serve.
  [[gnu::always_inline]] static Mask evaluate_arcs(ArcBatch &batch) {
    Mask unserved{};
    for (uint32_t s = 0; s < batch.count; s += n) {
      ArcBatch &b = by_one_register(batch);
      const Mask arc = L::load_mask(b.arc + s);
      unserved |= small_code ? evaluate_arcs_by_call(b, s, arc) : evaluate_arcs_at(b, s, arc);
    }
    return unserved;
  }
  [[gnu::noinline]] static Mask evaluate_arcs_by_call(ArcBatch &b, uint32_t s, const Mask &arc) {
    return evaluate_arcs_at(b, s, arc);
  }
  // The n slots from s on: the arcs in the mask `arc`. The angles of the others become 0.
  [[gnu::always_inline]] static Mask evaluate_arcs_at(ArcBatch &b, uint32_t s, const Mask &arc) {
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
    const Mask served = L::both(L::absolute(y) >= branch_cut_margin * x, arc);
    const Mask not_served = arc & ~served;
    L::store(b.angle + s, L::number(L::bits(L::kept(served, turn_angle<n>(x, y))) | not_served));
    store(b.Xx, b.Xy, b.Xz, s, kept(served, X));
    return not_served;
  }

  // Evaluates the arcs whose angles are not numbers, but not those on circles that doubles do not serve. All others
  // keep their values.
  static void complete_arcs(ArcBatch &b) {
    for (uint32_t s = 0; s < b.count; s += n) {
      const Real angle = L::load(b.angle + s);
      const Real square = L::load(b.square_of_distance + s);
      const Mask missing = L::both(angle != angle, square == square);
      if (!L::any(missing)) continue;
      const Vector X = load(b.Xx, b.Xy, b.Xz, s);
      evaluate_arcs_by_call(b, s, missing);
      L::store(b.angle + s, L::select(missing, L::load(b.angle + s), angle));
      L::store(b.Xx + s, L::select(missing, L::load(b.Xx + s), X.x));
      L::store(b.Xy + s, L::select(missing, L::load(b.Xy + s), X.y));
      L::store(b.Xz + s, L::select(missing, L::load(b.Xz + s), X.z));
    }
  }

  static bool evaluate(const BallOfSet &ball, ArcBatch &b) {
    const Mask circles = evaluate_circles(ball, b);
    evaluate_vertices(ball.r, b);
    const Mask arcs = evaluate_arcs(b);
    return !L::any(circles | arcs);
  }

  static AreaSums sum_areas(const ArcBatch &b, double radius) {
    Sums parts[sum_lanes / n];
    for (uint32_t lane = 0; lane < sum_lanes; lane += n) {
      Sums sums;
      for (uint32_t s = lane; s < b.count; s += sum_lanes) add_areas(Slots(by_one_register(b), s), radius, sums);
      parts[lane / n] = sums;
    }
    return area_sums(parts);
  }

  static GradientSums sum_gradient(const ArcBatch &batch, double radius, double weight) {
    Sums areas[sum_lanes / n], weighted[sum_lanes / n];
    for (uint32_t lane = 0; lane < sum_lanes; lane += n) {
      Sums area, weighted_area;
      for (uint32_t s = lane; s < batch.count; s += sum_lanes) {
        const ArcBatch &b = by_one_register(batch);
        const Slots slots(b, s);
        add_areas(slots, radius, area);
        add_weighted(b, slots, s, radius, weight, weighted_area);
      }
      areas[lane / n] = area;
      weighted[lane / n] = weighted_area;
    }
    return {area_sums(areas), weighted_sums(weighted)};
  }

 private:
  // The input of both kinds of sums, for n slots.
  struct Slots {
    Real height, angle;
    Vector X, u;

    [[gnu::always_inline]] Slots(const ArcBatch &b, uint32_t s)
        : height(L::load(b.twice_height + s)),
          angle(L::load(b.angle + s)),
          X(load(b.Xx, b.Xy, b.Xz, s)),
          u(axes(b, s)) {}
  };

  // With m = h u and X = 2 (q - p) x u: cos(cap) = h/r, m x (q - p) = -h X / 2, rho^2 = (r - h)(r + h).
  [[gnu::always_inline]] static void add_areas(const Slots &slots, double radius, Sums &sums) {
    const double diameter = 2 * radius;
    const Real along = (diameter - slots.height) * (diameter + slots.height) * slots.angle;
    const Vector area = slots.height * slots.X - along * slots.u;
    sums.a += slots.height * slots.angle;
    sums.b += area.x;
    sums.c += area.y;
    sums.d += area.z;
  }
  static AreaSums area_sums(const Sums (&parts)[sum_lanes / n]) {
    double of[4];
    store_sums(parts, of);
    return {of[0], {of[1], of[2], of[3]}};
  }
  // With weights s, the own area of ball k and the area of neighbour j together give for each arc
  //   dS/dc_k: u phi [ -s_k R_k (1 - h/d) - s_j R_j h/d ] + (q - p) x u [ s_k R_k - s_j R_j ]/d
  //   dS/dR_k: s_k phi (R_k^2/d - h) - s_j R_j R_k phi / d,   as (R_k^2 + R_j^2 - d^2)/(2 d) = R_k^2/d - h
  // The term with the factor s_k R_k - s_j R_j vanishes for equal balls. A sphere with R_k = 0 has only infinitely
  // short arcs, and every term is 0.
  [[gnu::always_inline]] static void add_weighted(const ArcBatch &b, const Slots &slots, uint32_t s, double radius,
                                                  double weight, Sums &sums) {
    const double own = weight * radius;
    const double *const other = b.has_weights ? b.other_weight : b.other_radius;
    const Real half = 0.5 * (own - L::load(other + s)) * L::load(b.inverse_distance + s);
    const Vector centre = slots.angle * (half * slots.height - own) * slots.u + half * slots.X;
    sums.a += centre.x;
    sums.b += centre.y;
    sums.c += centre.z;
    sums.d += slots.angle * (2 * radius * half - 0.5 * weight * slots.height);
  }
  static WeightedSums weighted_sums(const Sums (&parts)[sum_lanes / n]) {
    double of[4];
    store_sums(parts, of);
    return {{of[0], of[1], of[2]}, of[3]};
  }
};

}  // namespace
}  // namespace hsp
