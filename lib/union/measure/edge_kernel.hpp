// The kernels of edge_sums.hpp for registers of n doubles. Like everything in kernels they have internal
// linkage. The formulas are those of curvature.hpp.
#pragma once

#include "core/small_code.hpp"
#include "lanes/elementary_simd.hpp"
#include "lanes/wide_pairs.hpp"
#include "measure/edge_sums.hpp"

namespace hsp {
namespace {

// The square of an integer, exactly, as the sum of a multiple of 2^30 and of a rest below 2^48 in magnitude, for
// integers up to 2^33. Sums and differences of a dozen of these are exact in both parts, so that their sum is rounded
// once, whatever cancels. L: Wide or WidePairs.
template <class L>
struct ExactSquare {
  using Real = typename L::Real;
  Real high, low;

  ExactSquare(const Real &upper, const Real &lower) : high(upper), low(lower) {}
  explicit ExactSquare(const Real &x) {
    constexpr double to_multiples = 0x1.8p67;  // of 2^15
    const Real head = (x + to_multiples) - to_multiples;
    high = head * head;
    low = (x - head) * (x + head);
  }
  friend ExactSquare operator+(const ExactSquare &a, const ExactSquare &b) { return {a.high + b.high, a.low + b.low}; }
  friend ExactSquare operator-(const ExactSquare &a, const ExactSquare &b) { return {a.high - b.high, a.low - b.low}; }
  Real rounded() const { return high + low; }
};

// The same where products of doubles are exact, as EdgeBatch says, and so are their sums and differences.
template <class L>
struct PlainSquare {
  using Real = typename L::Real;
  Real square;

  explicit PlainSquare(const Real &x) : square(x * x) {}
  friend PlainSquare operator+(PlainSquare a, const PlainSquare &b) {
    a.square = a.square + b.square;
    return a;
  }
  friend PlainSquare operator-(PlainSquare a, const PlainSquare &b) {
    a.square = a.square - b.square;
    return a;
  }
  Real rounded() const { return square; }
};

// The edge of two balls of radii a and b, whose centres are v apart. With s = a + b and t = a - b
//   (2 rho d)^2 = 4 a^2 v.v - (v.v + a^2 - b^2)^2 = (s^2 - v.v)(v.v - t^2),
//   2 a b cos(beta) = a^2 + b^2 - v.v = (s^2 + t^2 - 2 v.v)/2,
// so all that cancels does so between integers, and the rest is products.
template <class L, template <class> class SquareOf = ExactSquare>
struct EdgeAngle {
  using Real = typename L::Real;
  using Mask = typename L::Mask;

  Real distance, product, cosine, beta;
  Mask is_proper;  // else the spheres touch, product and beta are 0

  EdgeAngle(const Real &a, const Real &b, const VectorOf<Real> &v) {
    using Square = SquareOf<L>;
    const Square s(a + b);
    const Square t(a - b);
    const Square U = Square(v.x) + Square(v.y) + Square(v.z);
    const Square to_outer = s - U;
    const Square to_inner = U - t;
    const Real outer = to_outer.rounded();
    const Real inner = to_inner.rounded();
    is_proper = L::both(outer > 0.0, inner > 0.0);
    distance = L::square_root(U.rounded());
    product = 0.5 * L::square_root(L::kept(is_proper, outer * inner));
    cosine = 0.25 * (to_outer - to_inner).rounded();
    beta = L::kept(is_proper, half_turn_angle<L>(cosine, product).sum());
  }
};

template <uint32_t n>
struct EdgeKernel {
  using L = Wide<double, n>;
  using Real = typename L::Real;
  using Mask = typename L::Mask;
  using Vector = VectorOf<Real>;
  using Edge = EdgeAngle<L>;
  using Pairs = WidePairs<double, n>;

  static Vector load(const double *x, const double *y, const double *z, uint32_t s) {
    return {L::load(x + s), L::load(y + s), L::load(z + s)};
  }
  static Vector gather(const double *x, const double *y, const double *z, const uint32_t *index) {
    return {L::gather(x, index), L::gather(y, index), L::gather(z, index)};
  }
  static Vector kept(const Mask &mask, const Vector &a) {
    return {L::kept(mask, a.x), L::kept(mask, a.y), L::kept(mask, a.z)};
  }
  static double sum_of_lanes(const double (&lanes)[sum_lanes]) { return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]); }

  // The sum x + M has the last place of the unit.
  static bool are_multiples(const double *numbers, uint32_t count, double unit) {
    const double to_multiples = 0x1.8p52 * unit;
    Mask others{};
    for (uint32_t k = 0; k < count; k += n) {
      const Real x = L::load_first(numbers + k, count - k);
      others |= (x + to_multiples) - to_multiples != x;
    }
    return !L::any(others);
  }

  // The sums of one lane of sum_lanes, of n of them.
  struct Sums {
    Real mean = L::all(0.0), radius = L::all(0.0);
    Vector centre{L::all(0.0), L::all(0.0), L::all(0.0)};
  };

  static double sum_edges(const BallOfSet &ball, const ArcBatch &arcs) {
    double lanes[sum_lanes];
    for (uint32_t lane = 0; lane < sum_lanes; lane += n) {
      Real sum = L::all(0.0);
      for (uint32_t s = lane; s < arcs.count; s += sum_lanes) {
        const Edge edge(L::all(ball.r), L::gather(ball.rs, arcs.other + s), load(arcs.vx, arcs.vy, arcs.vz, s));
        sum += integral(L::load(arcs.angle + s), edge.beta, edge.product, 1.0 / edge.distance);
      }
      L::store(lanes + lane, sum);
    }
    return 0.5 * sum_of_lanes(lanes);
  }

  static EdgeSums differentiate(double radius, const ArcBatch &arcs, double weight, EdgeBatch &edges) {
    if (!small_code && edges.has_plain_squares) return differentiate_by<PlainSquare>(radius, arcs, weight, edges);
    return differentiate_by<ExactSquare>(radius, arcs, weight, edges);
  }

 private:
  template <template <class> class SquareOf>
  static EdgeSums differentiate_by(double radius, const ArcBatch &arcs, double weight, EdgeBatch &edges) {
    double mean[sum_lanes], x[sum_lanes], y[sum_lanes], z[sum_lanes], by_radius[sum_lanes];
    Sums sums[sum_lanes / n];
    for (uint32_t lane = 0; lane < sum_lanes; lane += n) {
      add_edges<SquareOf>(radius, arcs, weight, lane, edges, sums[lane / n]);
    }
    for (uint32_t lane = 0; lane < sum_lanes; lane += n) {
      Sums &sum = sums[lane / n];
      add_vertices(radius, arcs, lane, edges, sum);
      L::store(mean + lane, sum.mean);
      L::store(x + lane, sum.centre.x);
      L::store(y + lane, sum.centre.y);
      L::store(z + lane, sum.centre.z);
      L::store(by_radius + lane, sum.radius);
    }
    return {-0.25 * sum_of_lanes(mean), {sum_of_lanes(x), sum_of_lanes(y), sum_of_lanes(z)}, sum_of_lanes(by_radius)};
  }

  // rho phi beta of an arc.
  static Real integral(const Real &phi, const Real &beta, const Real &product, const Real &inverse_distance) {
    return phi * beta * (product * inverse_distance);
  }

  // Areas of the two balls, each over its radius; rho beta; and what ball k's centre moves of the ends of its arcs:
  // with f = s beta (h_j/d) v/(rho d) half of (x_end - x_start) x f, which is -(s beta/(rho d)) h_j X/4 for the batch's
  // X. In parallel, as neither waits for the other: the third edge of the vertex where the arc starts.
  template <template <class> class SquareOf>
  static void add_edges(double radius, const ArcBatch &all_arcs, double weight, uint32_t lane, EdgeBatch &edges,
                        Sums &sums) {
    const double inverse_radius = radius > 0.0 ? 1.0 / radius : 0.0;
    for (uint32_t s = lane; s < all_arcs.count; s += sum_lanes) {
      const ArcBatch &arcs = by_one_register(all_arcs);
      const uint32_t *const before = arcs.previous + s;
      const Vector v = load(arcs.vx, arcs.vy, arcs.vz, s);
      const Vector third = gather(arcs.vx, arcs.vy, arcs.vz, before) - v;
      const Real other_radius = L::load(arcs.other_radius + s);
      const EdgeAngle<Pairs, SquareOf> both({L::all(radius), other_radius},
                                            {other_radius, L::gather(arcs.other_radius, before)},
                                            {{v.x, third.x}, {v.y, third.y}, {v.z, third.z}});
      const Mask is_proper = both.is_proper.first;
      const Real distance = both.distance.first;
      const Real product = both.product.first;
      const Real beta = both.beta.first;
      const Real other_weight = edges.has_weights ? L::load(edges.weight + s) : L::all(1.0);
      const Real before_weight = edges.has_weights ? L::gather(edges.weight, before) : L::all(1.0);
      const Real shared = 0.5 * (weight + other_weight);
      const Real third_shared = 0.5 * (other_weight + before_weight);
      const Real pull = L::kept(is_proper, shared * beta / product);
      L::store(edges.cosine + s, both.cosine.first);
      L::store(edges.pull + s, pull);
      L::store(edges.third_cosine + s, both.cosine.second);
      L::store(edges.third_force + s, third_shared * both.beta.second * both.product.second);

      const Real inverse = 1.0 / distance;
      const Real h = 0.5 * L::load(arcs.twice_height + s);
      const Real other_h = distance - h;
      const Real phi = L::kept(is_proper, L::load(arcs.angle + s));
      const Vector X = kept(is_proper, load(arcs.Xx, arcs.Xy, arcs.Xz, s));
      const Vector u = load(arcs.ux, arcs.uy, arcs.uz, s);
      const Real along = phi * (0.5 * (shared - pull * h * other_h) - (weight * other_h + other_weight * h) * inverse);
      const Real across = 0.5 * (weight - other_weight) * inverse - 0.25 * pull * other_h;
      sums.mean += shared * integral(phi, beta, product, inverse);
      sums.centre = sums.centre + (along * u + across * X);
      sums.radius += phi * ((weight - other_weight) * (radius * inverse) -
                            (weight - 0.5 * shared) * (h * inverse_radius) - 0.5 * pull * (radius * other_h));
    }
  }

  // The vertex where the slot's arc starts, of ball k with balls a and b: the loop comes in along the edge with b and
  // leaves along that with a. As c_l.c_l = (rho d)^2, c_a.c_k = g_ab g_kb - g_ka w_b, and so on, with g the products of
  // cosines of the three edges and w the squares of the radii.
  static void add_vertices(double radius, const ArcBatch &all_arcs, uint32_t lane, const EdgeBatch &edges, Sums &sums) {
    for (uint32_t s = lane; s < all_arcs.count; s += sum_lanes) {
      const ArcBatch &arcs = by_one_register(all_arcs);
      const uint32_t *const before = arcs.previous + s;
      const Real r_a = L::load(arcs.other_radius + s);
      const Real r_b = L::gather(arcs.other_radius, before);
      const Real g_a = L::load(edges.cosine + s);
      const Real g_b = L::gather(edges.cosine, before);
      const Real g_ab = L::load(edges.third_cosine + s);
      const Real along_a = g_ab * g_a - g_b * (r_a * r_a);
      const Real along_b = g_ab * g_b - g_a * (r_b * r_b);
      const Real root = L::load(arcs.root_discriminant + s);
      const Real pulled =
          L::load(edges.third_force + s) + L::load(edges.pull + s) * along_a + L::gather(edges.pull, before) * along_b;
      const Mask is_proper = L::load_mask(arcs.arc + s) & (root > 0.0);
      const Real lambda = L::kept(is_proper, pulled / root);
      sums.centre = sums.centre + (0.5 * lambda) * kept(is_proper, load(arcs.px, arcs.py, arcs.pz, s));
      sums.radius += lambda * radius;
    }
  }
};

}  // namespace
}  // namespace hsp
