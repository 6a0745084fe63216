// The kernels of edge_sums.hpp for registers of n doubles. As all code of kernels they have internal linkage. The
// formulas are those of curvature.hpp.
#pragma once

#include "core/small_code.hpp"
#include "curvature/edge_sums.hpp"
#include "lanes/angle.hpp"
#include "lanes/wide_pairs.hpp"
#include "measure/lane_sums.hpp"

namespace hsp {
namespace {

// The exact square of an integer up to 2^33, as the sum of a multiple of 2^30 and a rest below 2^48 in magnitude. Sums
// and differences of up to a dozen such squares are exact in both parts. So the final sum is rounded once, whatever
// cancels. L: Wide or WidePairs.
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

// The angle beta at which two spheres of radii a and b meet, with centres d apart. With g = a b cos(beta) = (a^2 + b^2
// - d^2)/2 there is
//   rho d = a b sin(beta) = sqrt((a b + g)(a b - g)),  2 (a b + g) = (a + b)^2 - d^2,  2 (a b - g) = d^2 - (a - b)^2.
// So only integers are subtracted, which is exact, and the rest is products. L: Wide or WidePairs.
template <class L>
struct EdgeAngle {
  using Real = typename L::Real;
  using Mask = typename L::Mask;

  Mask is_proper;              // false if the spheres touch: product and beta are 0
  Real product, cosine, beta;  // rho d, g and the angle

  // outer, inner, g: a b + g, a b - g and g, each rounded once.
  HSP_INLINE_UNLESS_SMALL EdgeAngle(const Real &outer, const Real &inner, const Real &g)
      : is_proper(L::both(outer > 0.0, inner > 0.0)),
        product(L::square_root(L::kept(is_proper, outer * inner))),
        cosine(g),
        beta(L::kept(is_proper, half_turn_angle<L>(cosine, product).sum())) {}
};

// The input of EdgeAngle, from radii and the vector from centre to centre.
template <class L>
struct EdgeLengths {
  using Real = typename L::Real;
  Real outer, inner, g, square_of_distance;

  HSP_INLINE_UNLESS_SMALL EdgeLengths(const Real &a, const Real &b, const VectorOf<Real> &v) {
    using Square = ExactSquare<L>;
    const Square s(a + b);
    const Square t(a - b);
    const Square U = Square(v.x) + Square(v.y) + Square(v.z);
    const Square to_outer = s - U;
    const Square to_inner = U - t;
    outer = 0.5 * to_outer.rounded();
    inner = 0.5 * to_inner.rounded();
    g = 0.25 * (to_outer - to_inner).rounded();
    square_of_distance = U.rounded();
  }
  EdgeAngle<L> angle() const { return {outer, inner, g}; }
};

template <uint32_t n>
struct EdgeKernel {
  using L = Wide<double, n>;
  using Real = typename L::Real;
  using Mask = typename L::Mask;
  using Vector = VectorOf<Real>;
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

  // The last place of the sum x + M, M the number added, is the unit: x is a multiple of the unit if nothing is lost.
  static bool are_multiples(const double *numbers, uint32_t count, double unit) {
    const double to_multiples = 0x1.8p52 * unit;
    Mask others{};
    const auto look_at = [&](const Real &x) { others |= (x + to_multiples) - to_multiples != x; };
    uint32_t k = 0;
    for (; k + n <= count; k += n) look_at(L::load(numbers + k));
    if (k < count) look_at(L::load_first(numbers + k, count - k));
    return !L::any(others);
  }

  // Sums of n lanes: the mean curvature, the derivatives by the centre, and the one by the radius.
  struct Sums {
    FourSums<n> mean_and_centre;
    Real radius = L::all(0.0);

    void add_centre(const Vector &term) {
      mean_and_centre.b += term.x;
      mean_and_centre.c += term.y;
      mean_and_centre.d += term.z;
    }
  };

  static double sum_edges(const BallOfSet &ball, const ArcBatch &arcs) {
    double lanes[sum_lanes];
    for (uint32_t lane = 0; lane < sum_lanes; lane += n) {
      Real sum = L::all(0.0);
      for (uint32_t s = lane; s < arcs.count; s += sum_lanes) {
        const EdgeLengths<L> lengths(L::all(ball.r), L::gather(ball.rs, arcs.other + s),
                                     load(arcs.vx, arcs.vy, arcs.vz, s));
        const EdgeAngle<L> edge = lengths.angle();
        sum += integral(L::load(arcs.angle + s), edge.beta, edge.product,
                        1.0 / L::square_root(lengths.square_of_distance));
      }
      L::store(lanes + lane, sum);
    }
    return 0.5 * sum_of_lanes(lanes);
  }

  static EdgeSums differentiate(double radius, const ArcBatch &arcs, double weight, EdgeBatch &edges) {
    if (!small_code && edges.has_plain_squares) return differentiate_by<PlainEdges>(radius, arcs, weight, edges);
    return differentiate_by<ExactEdges>(radius, arcs, weight, edges);
  }

 private:
  template <class EdgesOf>
  static EdgeSums differentiate_by(double radius, const ArcBatch &arcs, double weight, EdgeBatch &edges) {
    Sums sums[sum_lanes / n];
    for (uint32_t lane = 0; lane < sum_lanes; lane += n) {
      add_edges<EdgesOf>(radius, arcs, weight, lane, edges, sums[lane / n]);
    }
    FourSums<n> parts[sum_lanes / n];
    double by_radius[sum_lanes];
    for (uint32_t lane = 0; lane < sum_lanes; lane += n) {
      Sums &sum = sums[lane / n];
      add_vertices<EdgesOf>(radius, arcs, lane, edges, sum);
      parts[lane / n] = sum.mean_and_centre;
      L::store(by_radius + lane, sum.radius);
    }
    double of[4];
    store_sums(parts, of);
    return {-0.25 * of[0], {of[1], of[2], of[3]}, sum_of_lanes(by_radius)};
  }

  // rho phi beta of an arc.
  static Real integral(const Real &phi, const Real &beta, const Real &product, const Real &inverse_distance) {
    return phi * beta * (product * inverse_distance);
  }

  // The edge of a slot, and the third edge of the vertex at which the arc starts. They are computed in parallel, as
  // neither needs the other.
  struct Edges {
    Real r_a, r_b;  // the radii of the balls a and b of VertexEdges
    Real distance;
    EdgeAngle<Pairs> own_and_third;
    Real g_before = L::all(0.0);  // of the edge of the slot before, unless that is known only later
  };
  struct ExactEdges {
    static constexpr bool have_g_before = false;
    HSP_INLINE_UNLESS_SMALL static Edges at(double radius, const ArcBatch &arcs, uint32_t s) {
      const uint32_t *const before = arcs.previous + s;
      const Vector v = load(arcs.vx, arcs.vy, arcs.vz, s);
      const Vector third = gather(arcs.vx, arcs.vy, arcs.vz, before) - v;
      const Real r_a = L::load(arcs.other_radius + s);
      const Real r_b = L::gather(arcs.other_radius, before);
      const EdgeLengths<L> own(L::all(radius), r_a, v);
      const EdgeLengths<L> other(r_a, r_b, third);
      return {r_a,
              r_b,
              L::square_root(own.square_of_distance),
              {{own.outer, other.outer}, {own.inner, other.inner}, {own.g, other.g}}};
    }
  };
  // The same computed from H = 2 h d = v.v + r^2 - w, with w the square of the other radius, and from v.v_before.
  struct PlainEdges {
    static constexpr bool have_g_before = true;
    HSP_INLINE_UNLESS_SMALL static Edges at(double radius, const ArcBatch &arcs, uint32_t s) {
      const uint32_t *const before = arcs.previous + s;
      const double square = radius * radius;
      const Real H = L::load(arcs.scaled_height + s);
      const Real r_a = L::load(arcs.other_radius + s);
      const Real r_b = L::gather(arcs.other_radius, before);
      const Real product = radius * r_a;
      const Real third_product = r_a * r_b;
      const Real g = square - 0.5 * H;
      const Real g_before = square - 0.5 * L::gather(arcs.scaled_height, before);
      const Real g_third = g + (g_before + (L::load(arcs.product_with_previous + s) - square));
      return {r_a,
              r_b,
              L::square_root(H + (r_a * r_a - square)),
              {{product + g, third_product + g_third}, {product - g, third_product - g_third}, {g, g_third}},
              g_before};
    }
  };

  // The terms of edges: areas of the two balls, each over its radius; rho beta; and the motion of the ends of arcs with
  // ball k's centre. With f = s beta (h_j/d) v/(rho d) the last is half of (x_end - x_start) x f, which is -(s
  // beta/(rho d)) h_j X/4 for the batch's X.
  template <class EdgesOf>
  static void add_edges(double radius, const ArcBatch &all_arcs, double weight, uint32_t lane, EdgeBatch &edges,
                        Sums &sums) {
    const double inverse_radius = radius > 0.0 ? 1.0 / radius : 0.0;
    for (uint32_t s = lane; s < all_arcs.count; s += sum_lanes) {
      const ArcBatch &arcs = by_one_register(all_arcs);
      const Edges at = EdgesOf::at(radius, arcs, s);
      const EdgeAngle<Pairs> &pair = at.own_and_third;
      const Mask is_proper = pair.is_proper.first;
      const Real product = pair.product.first;
      const Real beta = pair.beta.first;
      const Real other_weight = edges.has_weights ? L::load(edges.weight + s) : L::all(1.0);
      const Real before_weight = edges.has_weights ? L::gather(edges.weight, arcs.previous + s) : L::all(1.0);
      const Real shared = 0.5 * (weight + other_weight);
      const Real third_shared = 0.5 * (other_weight + before_weight);
      const Real pull = L::kept(is_proper, shared * beta / product);
      const Real third_force = third_shared * pair.beta.second * pair.product.second;
      if constexpr (EdgesOf::have_g_before) {
        put_vertex(s, edges, {at.r_a, at.r_b, pair.cosine.first, at.g_before, pair.cosine.second, pull, third_force});
      } else {
        L::store(edges.cosine + s, pair.cosine.first);
        L::store(edges.force_by_previous + s, pair.cosine.second);
        L::store(edges.force + s, third_force);
      }
      L::store(edges.pull + s, pull);

      const Real inverse = 1.0 / at.distance;
      const Real h = 0.5 * L::load(arcs.twice_height + s);
      const Real other_h = at.distance - h;
      const Real phi = L::kept(is_proper, L::load(arcs.angle + s));
      const Vector X = kept(is_proper, load(arcs.Xx, arcs.Xy, arcs.Xz, s));
      const Vector u = load(arcs.ux, arcs.uy, arcs.uz, s);
      const Real along = phi * (0.5 * (shared - pull * h * other_h) - (weight * other_h + other_weight * h) * inverse);
      const Real across = 0.5 * (weight - other_weight) * inverse - 0.25 * pull * other_h;
      sums.mean_and_centre.a += shared * integral(phi, beta, product, inverse);
      sums.add_centre(along * u + across * X);
      sums.radius += phi * ((weight - other_weight) * (radius * inverse) -
                            (weight - 0.5 * shared) * (h * inverse_radius) - 0.5 * pull * (radius * other_h));
    }
  }

  // The vertex of balls k, a and b at which the slot's arc starts: the loop comes in along the edge with b and leaves
  // along the one with a. Here c_l.c_l = (rho d)^2, c_a.c_k = g_ab g_kb - g_ka w_b, and so on, with g = r r cos(beta)
  // of the three edges and w the squares of the radii.
  struct VertexEdges {
    Real r_a, r_b, g_a, g_b, g_ab, pull, third_force;
  };
  HSP_INLINE_UNLESS_SMALL static void put_vertex(uint32_t s, EdgeBatch &edges, const VertexEdges &of) {
    const Real along_a = of.g_ab * of.g_a - of.g_b * (of.r_a * of.r_a);
    const Real along_b = of.g_ab * of.g_b - of.g_a * (of.r_b * of.r_b);
    L::store(edges.force + s, of.third_force + of.pull * along_a);
    L::store(edges.force_by_previous + s, along_b);
  }
  template <class EdgesOf>
  static void add_vertices(double radius, const ArcBatch &all_arcs, uint32_t lane, EdgeBatch &edges, Sums &sums) {
    for (uint32_t s = lane; s < all_arcs.count; s += sum_lanes) {
      const ArcBatch &arcs = by_one_register(all_arcs);
      if constexpr (!EdgesOf::have_g_before) {
        const uint32_t *const before = arcs.previous + s;
        put_vertex(s, edges,
                   {L::load(arcs.other_radius + s), L::gather(arcs.other_radius, before), L::load(edges.cosine + s),
                    L::gather(edges.cosine, before), L::load(edges.force_by_previous + s), L::load(edges.pull + s),
                    L::load(edges.force + s)});
      }
      const Real root = L::load(arcs.root_discriminant + s);
      const Real pulled =
          L::load(edges.force + s) + L::gather(edges.pull, arcs.previous + s) * L::load(edges.force_by_previous + s);
      const Mask is_proper = L::load_mask(arcs.arc + s) & (root > 0.0);
      const Real lambda = L::kept(is_proper, pulled / root);
      sums.add_centre((0.5 * lambda) * kept(is_proper, load(arcs.px, arcs.py, arcs.pz, s)));
      sums.radius += lambda * radius;
    }
  }
};

}  // namespace
}  // namespace hsp
