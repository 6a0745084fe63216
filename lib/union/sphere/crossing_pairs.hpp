// Pairs of caps in lanes of floats or doubles, and the points in which their circles cross, by the formulas and with
// the error bounds of cap_pair.hpp and cap_pair_bounds.hpp: for kernels.
#pragma once

#include "lanes/words.hpp"
#include "sphere/cap_pair_bounds.hpp"

namespace hsp {
namespace {

// Caps in arrays.
template <class Real>
struct CapPointers {
  const Real *x, *y, *z, *b;
};

// Some caps, one in each lane, or one in all of them.
template <class Lanes>
struct LaneCaps {
  Lanes x, y, z, b;

  static LaneCaps load(const CapPointers<typename Lanes::Real> &caps, uint32_t k) {
    return {Lanes::load(caps.x + k), Lanes::load(caps.y + k), Lanes::load(caps.z + k), Lanes::load(caps.b + k)};
  }
  static LaneCaps all_of(const CapPointers<typename Lanes::Real> &caps, uint32_t k) {
    return {Lanes::all_of(caps.x + k), Lanes::all_of(caps.y + k), Lanes::all_of(caps.z + k), Lanes::all_of(caps.b + k)};
  }
  Lanes dot(const LaneCaps &other) const { return fused(x, other.x, fused(y, other.y, z * other.z)); }
};

// g and q of one cap with several.
template <class Lanes>
struct PairLanes {
  Lanes g, q;

  PairLanes(const LaneCaps<Lanes> &cap, const LaneCaps<Lanes> &others)
      : g(cap.dot(others)),
        q(fused((cap.b + cap.b) * g, others.b,
                minus_fused(others.b, others.b, minus_fused(g, g, minus_fused(cap.b, cap.b, Lanes::all(1)))))) {}
};

// Pairs that wait until there are enough of them. The numbers of the caps are small integers. The caller that adds
// pairs keeps how many there are, in a register: for the compiler, a vector that is stored may change any object, so a
// count here too.
template <class Lanes, uint32_t room>
struct alignas(32) CrossingPairs {
  using Real = typename Lanes::Real;
  static constexpr uint32_t size = room + Lanes::lanes;
  Real jx[size], jy[size], jz[size], jb[size];
  Real kx[size], ky[size], kz[size], kb[size];
  Real g[size], q[size];
  Real j[size], k[size];

  static bool is_full(uint32_t count) { return count > room - Lanes::lanes; }
  // Adds the chosen ones of the pairs of cap j with caps k to `count` others. Returns how many there are then.
  uint32_t add(uint32_t count, Lanes j_cap, const LaneCaps<Lanes> &cap, Lanes k_caps, const LaneCaps<Lanes> &others,
               const PairLanes<Lanes> &pair, LaneBits chosen) {
    const FrontOrder order = front_order<Lanes>(chosen);
    cap.x.store(jx + count);
    cap.y.store(jy + count);
    cap.z.store(jz + count);
    cap.b.store(jb + count);
    store_front(kx + count, others.x, order);
    store_front(ky + count, others.y, order);
    store_front(kz + count, others.z, order);
    store_front(kb + count, others.b, order);
    store_front(g + count, pair.g, order);
    store_front(q + count, pair.q, order);
    j_cap.store(j + count);
    store_front(k + count, k_caps, order);
    return count + ones(chosen);
  }
};

// Points of the sphere, each with the bound of the error of its depth u.p - b in any cap.
template <class Lanes>
struct LanePoints {
  Lanes x, y, z, error;

  Lanes depth(const LaneCaps<Lanes> &cap) const {
    return fused(x, cap.x, fused(y, cap.y, fused_minus(z, cap.z, cap.b)));
  }
};

// The points p- and p+ of pairs number p, p + 1, ...
template <class Lanes>
struct LaneCrossings {
  LanePoints<Lanes> minus, plus;

  template <uint32_t room>
  LaneCrossings(const CrossingPairs<Lanes, room> &pairs, uint32_t p)
      : LaneCrossings({Lanes::load(pairs.jx + p), Lanes::load(pairs.jy + p), Lanes::load(pairs.jz + p),
                       Lanes::load(pairs.jb + p)},
                      {Lanes::load(pairs.kx + p), Lanes::load(pairs.ky + p), Lanes::load(pairs.kz + p),
                       Lanes::load(pairs.kb + p)},
                      Lanes::load(pairs.g + p), Lanes::load(pairs.q + p)) {}
  // Of caps u and v, with their g and q.
  LaneCrossings(const LaneCaps<Lanes> &u, const LaneCaps<Lanes> &v, Lanes g, Lanes q) {
    using Bounds = CapPairBounds<typename Lanes::Real>;
    const Lanes root = square_root(q);
    const Lanes S = minus_fused(g, g, Lanes::all(1));
    const Lanes shared = Lanes::all(1) / (S * root);
    const Lanes s = root * shared;
    const Lanes inverse_root = S * shared;
    const Lanes alpha = minus_fused(g, v.b, u.b) * s;
    const Lanes beta = minus_fused(g, u.b, v.b) * s;
    const Lanes gamma = root * s;
    const Lanes mx = fused(alpha, u.x, beta * v.x);
    const Lanes my = fused(alpha, u.y, beta * v.y);
    const Lanes mz = fused(alpha, u.z, beta * v.z);
    const Lanes nx = fused_minus(u.y, v.z, u.z * v.y);
    const Lanes ny = fused_minus(u.z, v.x, u.x * v.z);
    const Lanes nz = fused_minus(u.x, v.y, u.y * v.x);
    const Lanes error = s * Lanes::all(Bounds::roundoff) *
                        fused(s, Lanes::all(Bounds::point_s), inverse_root * Lanes::all(Bounds::point_root));
    minus = {minus_fused(gamma, nx, mx), minus_fused(gamma, ny, my), minus_fused(gamma, nz, mz), error};
    plus = {fused(gamma, nx, mx), fused(gamma, ny, my), fused(gamma, nz, mz), error};
  }
};

}  // namespace
}  // namespace hsp
