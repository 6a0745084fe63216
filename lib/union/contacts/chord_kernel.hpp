// The kernel of chord_cuts.hpp for registers of n doubles. Like everything in kernels it has internal
// linkage.
#pragma once

#include "contacts/chord_cuts.hpp"
#include "lanes/wide.hpp"
#include "sphere/cap_pair_bounds.hpp"

namespace hsp {
namespace {

template <uint32_t n>
struct ChordKernel {
  using L = Wide<double, n>;
  using Real = typename L::Real;
  using Mask = typename L::Mask;
  using Bounds = CapPairBounds<double>;

  // The chord of two caps, by the formulas of cap_pair.hpp.
  struct Chord {
    double m[3], w[3], q, error;

    [[gnu::always_inline]] Chord(const CapColumns &caps, uint32_t j, uint32_t k, double direction) {
      const double u[3] = {caps.ux[j], caps.uy[j], caps.uz[j]}, bj = caps.b[j];
      const double v[3] = {caps.ux[k], caps.uy[k], caps.uz[k]}, bk = caps.b[k];
      const double g = u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
      const double S = 1.0 - g * g;
      q = S - (bj * bj + bk * bk) + 2.0 * (g * bj * bk);
      const double root = std::sqrt(q);
      const double shared = 1.0 / (S * root);
      const double s = root * shared, inverse_root = S * shared;
      const double alpha = (bj - g * bk) * s, beta = (bk - g * bj) * s;
      const double gamma = direction * (root * s);
      for (uint32_t x = 0; x < 3; ++x) {
        const uint32_t y = (x + 1) % 3, z = (x + 2) % 3;
        m[x] = alpha * u[x] + beta * v[x];
        w[x] = gamma * (u[y] * v[z] - u[z] * v[y]);
      }
      error = (Bounds::roundoff * s) * (Bounds::point_s * s + Bounds::point_root * inverse_root);
    }
    // Written so that what is not a number is certain of nothing.
    bool is_certain() const { return q > Bounds::points && error <= CapColumns::most_error; }
  };

  // Each lane has its own first and second.
  static uint32_t nearest(const CapColumns &caps, uint32_t first, uint32_t last, uint32_t j, uint32_t k,
                          double direction) {
    const Chord chord(caps, j, k, direction);
    if (!chord.is_certain()) return no_cut;
    const Real mx = L::all(-chord.m[0]), my = L::all(-chord.m[1]), mz = L::all(-chord.m[2]);
    const Real wx = L::all(chord.w[0]), wy = L::all(chord.w[1]), wz = L::all(chord.w[2]);
    const Real slope = L::all(CapColumns::least_slope);
    const Real twice = L::all(2 * CapColumns::least_slope);
    const Real none = L::all(CapColumns::none);
    constexpr int64_t numbers = CapColumns::most_caps - 1;
    Mask number{};
    for (uint32_t lane = 0; lane < n; ++lane) number[lane] = lane;
    number += first;
    Real best = none, second = none;
    Mask unclear{};
    for (uint32_t t = first; t < last; t += n) {
      const Real ux = L::load(caps.ux + t), uy = L::load(caps.uy + t), uz = L::load(caps.uz + t);
      const Real depth = L::fused(mz, uz, L::fused(my, uy, L::fused(mx, ux, L::load(caps.b + t))));  // -f
      const Real slant = L::fused(wz, uz, L::fused(wy, uy, wx * ux));                                // g
      unclear += L::larger(depth, L::absolute(slant)) <= twice;
      const Real quotient = L::select(slant > slope, depth / slant, none);
      const Real s = L::number((L::bits(quotient) & ~(Mask{} + numbers)) | number);
      second = L::smaller(second, L::larger(best, s));
      best = L::smaller(s, best);
      number += n;
    }
    double least = best[0], next = second[0];
    for (uint32_t lane = 1; lane < n; ++lane) {
      const double larger = least < best[lane] ? best[lane] : least;
      const double other = next < second[lane] ? next : second[lane];
      next = larger < other ? larger : other;
      least = least < best[lane] ? least : best[lane];
    }
    const double gap = chord.error * (8 / CapColumns::least_slope) + 0x1p-34;
    uint64_t bits = 0;
    std::memcpy(&bits, &least, sizeof bits);
    return L::count(unclear) == 2 && least < 2.0 && next - least > gap ? static_cast<uint32_t>(bits & numbers) : no_cut;
  }
};

}  // namespace
}  // namespace hsp
