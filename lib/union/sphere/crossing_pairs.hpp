// For kernels: pairs of caps that wait until there are enough to compute their points in lanes, and the tests of points
// against all caps. The formulas and error bounds are those of cap_pair.hpp. A point inside a cap is covered. A point
// that is outside all caps but its own two, on whose circles it lies, is free.
#pragma once

#include "lanes/words.hpp"
#include "sphere/cap_pair.hpp"

namespace hsp {
namespace {

// Pairs that wait until there are enough of them. j and k are the numbers of the caps, small integers as floats. The
// caller keeps the number of pairs, in a register: to the compiler, a store of a vector may change any object, and so
// it might change a count kept here.
template <class Lanes, uint32_t room>
struct alignas(32) CrossingPairs {
  using Real = typename Lanes::Real;
  static constexpr uint32_t size = room + Lanes::lanes;
  Real jx[size], jy[size], jz[size], jb[size];
  Real kx[size], ky[size], kz[size], kb[size];
  Real g[size], q[size];
  Real j[size], k[size];

  static bool is_full(uint32_t count) { return count > room - Lanes::lanes; }
  // Adds the chosen pairs of cap j with caps k behind `count` others. Returns how many pairs there are then.
  uint32_t add(uint32_t count, Lanes j_cap, const LaneCaps<Lanes> &cap, Lanes k_caps, const LaneCaps<Lanes> &others,
               const LanePairs<Lanes> &pairs, LaneBits chosen) {
    const FrontOrder order = front_order<Lanes>(chosen);
    cap.x.store(jx + count);
    cap.y.store(jy + count);
    cap.z.store(jz + count);
    cap.b.store(jb + count);
    store_front(kx + count, others.x, order);
    store_front(ky + count, others.y, order);
    store_front(kz + count, others.z, order);
    store_front(kb + count, others.b, order);
    store_front(g + count, pairs.g, order);
    store_front(q + count, pairs.q, order);
    j_cap.store(j + count);
    store_front(k + count, k_caps, order);
    return count + ones(chosen);
  }
  // The points of pairs number p, p + 1, ...
  LaneCrossings<Lanes> points(uint32_t p) const {
    return {LaneCaps<Lanes>::load({jx, jy, jz, jb}, p), LaneCaps<Lanes>::load({kx, ky, kz, kb}, p), Lanes::load(g + p),
            Lanes::load(q + p)};
  }
};

// Tests points, one in each lane, against caps that come one by one.
template <class Lanes>
struct PointTest {
  LanePoints<Lanes> point;
  Lanes deepest = Lanes::all(-4);
  LaneCounts<Lanes> near{};

  explicit PointTest(const LanePoints<Lanes> &p) : point(p) {}
  void against(const LaneCaps<Lanes> &cap) {
    const Lanes depth = point.depth(cap);
    deepest = larger(deepest, depth);
    near.count_not_less(depth, -point.error);
  }
  LaneBits covered() const { return greater(deepest, point.error); }
  LaneBits outside() const { return near.equal(2); }
};

// The lanes of two vectors of points that do not certainly lie inside one of caps begin .. end - 1.
struct NotCovered {
  LaneBits first, second;

  NotCovered(const CapPointers<float> &caps, uint32_t begin, uint32_t end, const LanePoints<Floats> &a,
             const LanePoints<Floats> &b) {
    Floats deepest_a = Floats::all(-4.0F), deepest_b = deepest_a;
#pragma GCC unroll 2
    for (uint32_t t = begin; t < end; ++t) {
      const LaneCaps<Floats> cap = LaneCaps<Floats>::all_of(caps, t);
      deepest_a = larger(deepest_a, a.depth(cap));
      deepest_b = larger(deepest_b, b.depth(cap));
    }
    first = not_greater(deepest_a, a.error);
    second = not_greater(deepest_b, b.error);
  }
};

// One point against all caps, some of them at a time. The point is open if it is not certainly covered. If it is open
// and certain, it is free.
struct PointState {
  bool open, certain;

  // The point is in all lanes.
  [[gnu::always_inline]] static PointState among(const CapPointers<float> &caps, uint32_t count,
                                                 const LanePoints<Floats> &point) {
    const Floats below = -point.error;
    Floats deepest = Floats::all(-4.0F);
    uint32_t near = 0;
    // Lanes after the last cap are far from the point, unless nothing is certain of it.
    for (uint32_t t = 0; t < count; t += Floats::lanes) {
      const Floats depth = point.depth(LaneCaps<Floats>::load(caps, t));
      deepest = larger(deepest, depth);
      near += ones(not_less(depth, below));
    }
    return {greater(deepest, point.error) == 0, near == 2};
  }
};

}  // namespace
}  // namespace hsp
