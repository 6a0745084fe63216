// The kernels of saddle_sums.hpp for registers of n doubles. Like everything in kernels they have internal
// linkage.
//
// Saddle patches are what the probe's lower side sweeps while it rolls along an arc, touching two balls. On the circle
// of balls i and j, with u from c_i to c_j, e the radial unit vector and rho the circle's radius, a patch is
//   x = y + p (-cos(a) e + sin(a) u),  -t_i <= a <= t_j,  tan t_i = h_i / rho,
// with h_i the height of the circle's plane above c_i. The two balls share it at a = 0. Nothing cuts it but its own
// axis (PROOFS.md, section 4): where rho < p and the plane lies between the centres, what remains ends at the cusps,
// cos a = rho/p.
#pragma once

#include "lanes/angle.hpp"
#include "measure/lane_sums.hpp"
#include "surface/saddle_sums.hpp"

namespace hsp {
namespace {

template <uint32_t n>
struct SaddleKernel {
  using L = Wide<double, n>;
  using Real = typename L::Real;
  using Mask = typename L::Mask;
  using Vector = VectorOf<Real>;

  // Below these ratios of squares the rounding of the height matters too much: for the circle's radius, and for the
  // distance of its cusps from its middle.
  static constexpr double least_square_of_radius = 1.0 / 64, least_square_of_half_way = 0x1p-16;

  // p^2 - rho^2 is h^2 - (R^2 - p^2), which loses less where balls are small.
  static bool find_circles(const ArcBatch &b, const RolledBall &ball, SaddleCircles &circles) {
    const double radius = ball.radius, excess = (radius - ball.probe) * (radius + ball.probe);
    Mask unserved{};
    for (uint32_t s = 0; s < b.count; s += n) {
      const Real height = 0.5 * L::load(b.twice_height + s);
      const Real square = (radius - height) * (radius + height);
      const Real square_of_height = height * height;
      const Real half_way = square_of_height - excess;
      const Mask served = L::both(square >= least_square_of_radius * radius * radius,
                                  L::absolute(half_way) >= least_square_of_half_way * square_of_height);
      const Mask between = L::both(height > 0.0, height * L::load(b.inverse_distance + s) < 1.0);
      const Mask cusped = L::both(between, half_way > 0.0);
      L::store(circles.radius + s, L::valid(served, L::square_root(L::kept(served, square))));
      L::store(circles.half_way + s, L::square_root(L::kept(cusped, half_way)));
      unserved |= ~served;
    }
    return !L::any(unserved);
  }

  // Integrals of 1, cos, sin, cos^2 and sin cos over a side's part of the profile, -t <= a <= min(0, t'), or up to its
  // cusp; 0 if that is empty. Between balls that are near each other this part is as short as the distance of their
  // centres. Derivatives are divided by that distance, so nothing here may be the small difference of two rounded
  // numbers. The angle from the part's end a to its end b has the sine
  //   h/R up to 0,   rho d/(R R') up to t', as h + h' = d,   rho (h - k)/(R p) up to the cusp, k^2 = p^2 - rho^2,
  // where h^2 - k^2 = R^2 - p^2; and sin b - sin a = t (cos a + cos b), cos a - cos b = t (sin a + sin b) with
  // t = tan((b - a)/2).
  struct Profile {
    Real T, S, Q, C2, SC;

    Profile(const Real &probe, const Real &rho, const Real &half_way, const Real &height, const Real &radius,
            const Real &other_height, const Real &other_radius) {
      const Mask cusped = half_way > 0.0;
      const Mask whole = ~(cusped | (other_height < 0.0));
      const Real sin_a = -height / radius;
      const Real cos_a = rho / radius;
      const Real end = L::select(cusped, probe, other_radius);
      const Real sin_b = L::kept(~whole, L::select(cusped, -half_way, other_height) / end);
      const Real cos_b = L::select(whole, L::all(1.0), rho / end);
      const Real rise =
          L::select(cusped, (radius - probe) * (radius + probe) / (height + half_way), height + other_height);
      const Real sine = L::select(whole, -sin_a, cos_a * rise / end);
      const Mask there = L::both(rho > 0.0, sine > 0.0);
      const Real cosine = cos_b * cos_a + sin_b * sin_a;
      const Real tangent = sine / (1.0 + cosine);
      T = L::kept(there, half_turn_angle<L>(cosine, L::select(there, sine, L::all(1.0))).sum());
      S = L::kept(there, tangent * (cos_a + cos_b));
      Q = L::kept(there, tangent * (sin_a + sin_b));
      C2 = 0.5 * (T + L::kept(there, sine * (cos_a * cos_b - sin_a * sin_b)));
      SC = 0.5 * S * L::kept(there, sin_a + sin_b);
    }
    // The sum of two sides' integrals, seen from the first side.
    Profile(const Profile &own, const Profile &other)
        : T(own.T + other.T), S(own.S + other.S), Q(own.Q - other.Q), C2(own.C2 + other.C2), SC(own.SC - other.SC) {}
    // The same, each side with a weight.
    Profile(double weight, const Profile &own, double other_weight, const Profile &other)
        : T(weight * own.T + other_weight * other.T),
          S(weight * own.S + other_weight * other.S),
          Q(weight * own.Q - other_weight * other.Q),
          C2(weight * own.C2 + other_weight * other.C2),
          SC(weight * own.SC - other_weight * other.SC) {}
  };

  struct Slot {
    Real probe, rho, half_way, inverse_rho, height, other_height, radius, other_radius, inverse_distance, angle;
    Vector axis, half_X;

    Slot(const ArcBatch &b, const SaddleCircles &circles, const RolledBall &ball, uint32_t s)
        : probe(L::all(ball.probe)),
          rho(L::load(circles.radius + s)),
          half_way(L::load(circles.half_way + s)),
          inverse_rho(L::kept(rho > 0.0, 1.0 / rho)),
          height(0.5 * L::load(b.twice_height + s)),
          radius(L::all(ball.radius)),
          other_radius(L::gather(ball.radii, b.other + s)),
          inverse_distance(L::load(b.inverse_distance + s)),
          angle(L::load(b.angle + s)),
          axis{L::load(b.ux + s), L::load(b.uy + s), L::load(b.uz + s)},
          half_X{0.5 * L::load(b.Xx + s), 0.5 * L::load(b.Xy + s), 0.5 * L::load(b.Xz + s)} {
      other_height = 1.0 / inverse_distance - height;
    }
    Profile own_profile() const { return Profile(probe, rho, half_way, height, radius, other_height, other_radius); }
    Profile other_profile() const { return Profile(probe, rho, half_way, other_height, other_radius, height, radius); }
  };

  // With rho I = X/2 the integral of rho e over the arc:
  //   area         phi p (rho T - p S)
  //   vector area  p [ (S - p C2 / rho) rho I - phi (rho Q - p SC) u ]
  //   integral of (x - m).n   phi p [ (rho^2 + p^2) S - rho p (C2 + T) ]
  // Adds the area to sums.a and three times the term of the volume to sums.b.
  using Sums = FourSums<n>;
  static void add_measures(const Slot &s, const Profile &own, const RolledBall &ball, Sums &sums) {
    const Real term = s.angle * s.probe * (s.rho * own.T - s.probe * own.S);
    sums.a += L::kept(term > 0.0, term);
    const Real about_centre =
        s.angle * s.probe * ((s.rho * s.rho + s.probe * s.probe) * own.S - s.rho * s.probe * (own.C2 + own.T));
    const Vector vector_area = s.probe * (own.S - s.probe * own.C2 * s.inverse_rho) * s.half_X -
                               s.probe * s.angle * (s.rho * own.Q - s.probe * own.SC) * s.axis;
    const Vector arm = Vector{L::all(ball.arm[0]), L::all(ball.arm[1]), L::all(ball.arm[2])} + s.height * s.axis;
    sums.b += about_centre + dot(arm, vector_area);
  }

  // The ball's share of the normal speed is alpha = R (h' cos a - rho sin a)/(rho d), and the mean curvature's factor
  // 1/(rho - p cos a) cancels against the area element:
  //   w_V = p [ k_c (rho S - p C2) + k_s (rho Q - p SC) ],   w_A = k_c (-rho S + 2 p C2) + k_s (-rho Q + 2 p SC),
  // k_c = h'/(rho d), k_s = -1/d. The derivative by the centre is w (rho I + h phi u), that by the radius w R phi. The
  // area's derivative by the offset is phi (rho T - 2 p S), of which each of the two balls adds half.
  struct DerivativeSums {
    Sums area, volume;  // by the centre and the radius
    Real area_offset = L::all(0.0);

    void add(const Slot &s, const Profile &whole) {
      const Real k_c = s.other_height * s.inverse_rho * s.inverse_distance;
      const Real along = s.rho * whole.S, across = s.rho * whole.Q;
      const Real w_V =
          s.probe * (k_c * (along - s.probe * whole.C2) - s.inverse_distance * (across - s.probe * whole.SC));
      const Real w_A =
          k_c * (2.0 * s.probe * whole.C2 - along) - s.inverse_distance * (2.0 * s.probe * whole.SC - across);
      const Vector g = s.half_X + s.height * s.angle * s.axis;
      add_times(area, w_A, g, s);
      add_times(volume, w_V, g, s);
      area_offset += 0.5 * s.angle * (s.rho * whole.T - 2.0 * s.probe * whole.S);
    }

   private:
    static void add_times(Sums &sums, const Real &w, const Vector &g, const Slot &s) {
      sums.a += w * g.x;
      sums.b += w * g.y;
      sums.c += w * g.z;
      sums.d += w * s.radius * s.angle;
    }
  };

  static SaddleMeasures measure(const ArcBatch &b, const SaddleCircles &circles, const RolledBall &ball) {
    Sums sums[sum_lanes / n];
    for (uint32_t lane = 0; lane < sum_lanes; lane += n) {
      for (uint32_t s = lane; s < b.count; s += sum_lanes) {
        const Slot slot(by_one_register(b), circles, ball, s);
        add_measures(slot, slot.own_profile(), ball, sums[lane / n]);
      }
    }
    double of[4];
    store_sums(sums, of);
    return {of[0], of[1]};
  }

  static SaddleDerivatives differentiate(const ArcBatch &b, const SaddleCircles &circles, const RolledBall &ball) {
    Sums measures[sum_lanes / n], area[sum_lanes / n], volume[sum_lanes / n];
    for (uint32_t lane = 0; lane < sum_lanes; lane += n) {
      DerivativeSums sums;
      for (uint32_t s = lane; s < b.count; s += sum_lanes) {
        const Slot slot(by_one_register(b), circles, ball, s);
        const Profile own = slot.own_profile();
        add_measures(slot, own, ball, measures[lane / n]);
        sums.add(slot, Profile(own, slot.other_profile()));
      }
      area[lane / n] = sums.area;
      volume[lane / n] = sums.volume;
      measures[lane / n].c = sums.area_offset;
    }
    double of[4];
    SaddleDerivatives result;
    store_sums(area, result.area);
    store_sums(volume, result.volume);
    store_sums(measures, of);
    result.measures = {of[0], of[1]};
    result.area_offset = of[2];
    return result;
  }
};

}  // namespace
}  // namespace hsp
