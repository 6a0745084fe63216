// All pairs of up to 16 caps of one ball, with a bit for each cap.
//
// As an example caps 0 and 1 whose circles cross, and cap 2, which lies in cap 1 and apart from cap 0:
//   of cap 0     cross 010      separate 100
//   of cap 1     cross 001      contains 100
//   of cap 2     inside 010     separate 001
#include "sphere/few_caps.hpp"

#include <cstring>

#include "sphere/crossing_pairs.hpp"
#include "sphere/pairs_of_few.hpp"

namespace hsp::HSP_TARGET {
namespace {

// Bits of caps.
using CapBits = uint32_t;

// How the circle of one cap lies to the circles of all others, as far as that is certain.
struct Relations {
  CapBits cross = 0;      // they cross
  CapBits at_points = 0;  // they cross, and their crossing points are certain
  CapBits separate = 0;   // neither lies in the other's cap
  CapBits inside = 0;     // it lies inside the other cap
  CapBits contains = 0;   // the other one lies inside its cap
};

template <class Lanes>
[[gnu::always_inline]] inline void relate(const LanePairs<Lanes> &pairs, uint32_t shift, Relations &relations) {
  const LaneBits apart = pairs.certainly_apart();
  relations.cross |= pairs.certainly_cross() << shift;
  relations.at_points |= pairs.certainly_cross_in_points() << shift;
  relations.separate |= (apart & pairs.certainly_separate()) << shift;
  relations.inside |= (apart & pairs.certainly_inside()) << shift;
  relations.contains |= (apart & pairs.certainly_contains()) << shift;
}

// Writes p- and p+ of a pair as they are free (1) or not (0), without a branch: there is room for one point more.
inline void put_points(uint8_t j, uint8_t k, uint32_t minus, uint32_t plus, FewCaps &found) {
  found.point[found.points] = {j, k, 0};
  found.points += minus;
  found.point[found.points] = {j, k, 1};
  found.points += plus;
}

// Disjoint sets of caps.
struct Clusters {
  CapBits member[most_few_caps];
  uint32_t count = 0;

  // Adds a set, and unites it with all sets that have a cap in common with it.
  void add(CapBits joined) {
    uint32_t kept = 0;
    for (uint32_t c = 0; c < count; ++c) {
      const CapBits other = member[c];
      const bool meets = (other & joined) != 0;
      member[kept] = other;
      joined |= meets ? other : 0U;
      kept += meets ? 0U : 1U;
    }
    member[kept] = joined;
    count = kept + 1;
  }
};

// A compile-time constant as an argument.
template <uint32_t n>
struct Number {
  constexpr operator uint32_t() const { return n; }
};

template <class Lanes, uint32_t vectors>
class FewCapsSearch {
 public:
  using Real = typename Lanes::Real;
  using SomeCaps = LaneCaps<Lanes>;
  using Pairs = CrossingPairs<Lanes, 32>;

  FewCapsSearch(const CapPointers<Real> &caps, uint32_t count, uint32_t first_later, FewCaps &found)
      : caps_(caps), count_(count), first_later_(first_later), found_(found) {}

  bool run() {
    found_.points = 0;
    found_.crossing = 0;
    if (!add_rows()) return false;
    found_.clusters = clusters_.count;
    found_.free_circles = first_caps(count_) & ~first_caps(first_later_) & ~touched_;
    return test_points();
  }

 private:
  static CapBits first_caps(uint32_t count) { return (1U << count) - 1U; }

  // Each cap with the caps of its own vector and of later vectors. If all caps are in one or two vectors, these stay in
  // registers, and each has its own loop.
  bool add_rows() {
    if constexpr (vectors <= 2) {
      SomeCaps all_caps[vectors];
      for (uint32_t v = 0; v < vectors; ++v) all_caps[v] = SomeCaps::load(caps_, Lanes::lanes * v);
      return add_rows<0>(all_caps);
    }
    const uint32_t used = (count_ + Lanes::lanes - 1) / Lanes::lanes;
    for (uint32_t j = 0; j < count_; ++j) {
      if (!add_row(j, j / Lanes::lanes, used, nullptr)) return false;
    }
    return true;
  }
  template <uint32_t first>
  bool add_rows(const SomeCaps (&all_caps)[vectors]) {
    constexpr uint32_t begin = Lanes::lanes * first, end = begin + Lanes::lanes;
    for (uint32_t j = begin; j < (first + 1 < vectors ? end : count_); ++j) {
      if (!add_row(j, Number<first>(), Number<vectors>(), all_caps)) return false;
    }
    if constexpr (first + 1 < vectors) return add_rows<first + 1>(all_caps);
    return true;
  }

  // Cap j with the caps of vectors first .. last - 1; all_caps: these vectors if they are in registers, else null. A
  // pair counts once, at its first cap.
  template <class First, class Last>
  bool add_row(uint32_t j, First first, Last last, const SomeCaps *all_caps) {
    const SomeCaps cap = SomeCaps::all_of(caps_, j);
    const CapBits own = 1U << j;
    const CapBits after = first_caps(count_) & ~first_caps(j + 1);
    Relations relations;
    for (uint32_t v = first; v < last; ++v) {
      const uint32_t shift = Lanes::lanes * v;
      const SomeCaps others = all_caps != nullptr ? all_caps[v] : SomeCaps::load(caps_, shift);
      const LanePairs<Lanes> pairs(cap, others);
      relate(pairs, shift, relations);
      if (j < first_later_) continue;
      const LaneBits crossing = (relations.at_points & after) >> shift & ((1U << Lanes::lanes) - 1U);
      if (crossing == 0) continue;
      if (Pairs::is_full(pair_count_) && !test_points()) return false;
      pair_count_ = pairs_.add(pair_count_, Lanes::all(static_cast<Real>(j)), cap,
                               Lanes::ascending() + Lanes::all(static_cast<Real>(shift)), others, pairs, crossing);
    }
    const CapBits cross = relations.cross & after;
    const CapBits inside = relations.inside & after;
    const CapBits contains = relations.contains & after;
    const CapBits meet = cross | inside | contains;
    unsure_ |= after & ~(meet | relations.separate);
    if (j >= first_later_) unsure_ |= cross & ~relations.at_points;
    touched_ |= cross | contains | ((cross | inside) != 0 ? own : 0U);
    clusters_.add(meet | own);
    return unsure_ == 0;
  }

  // Tests the points of the pairs that wait against all caps. False if a point is neither certainly covered nor
  // certainly free. Out of line: inlined into the loop over rows, it would take the registers of that loop.
  [[gnu::noinline]] bool test_points() {
    const uint32_t count = pair_count_;
    for (uint32_t p = 0; p < count; p += Lanes::lanes) {
      const LaneCrossings<Lanes> crossings = pairs_.points(p);
      PointTest<Lanes> minus(crossings.minus), plus(crossings.plus);
      for (uint32_t t = 0; t < count_; ++t) {
        const LaneCaps<Lanes> cap = LaneCaps<Lanes>::all_of(caps_, t);
        minus.against(cap);
        plus.against(cap);
      }
      const LaneBits valid = first_lanes(count - p) & ((1U << Lanes::lanes) - 1U);
      const LaneBits minus_covered = minus.covered(), plus_covered = plus.covered();
      const LaneBits minus_outside = minus.outside(), plus_outside = plus.outside();
      if (((minus_covered | minus_outside) & (plus_covered | plus_outside) & valid) != valid) return false;
      keep_free(p, minus_outside & ~minus_covered & valid, plus_outside & ~plus_covered & valid);
    }
    found_.crossing += count;
    pair_count_ = 0;
    return true;
  }

  void keep_free(uint32_t p, LaneBits minus, LaneBits plus) {
    for (LaneBits either = minus | plus; either != 0; either &= either - 1) {
      const uint32_t lane = lowest(either);
      put_points(static_cast<uint8_t>(pairs_.j[p + lane]), static_cast<uint8_t>(pairs_.k[p + lane]), minus >> lane & 1U,
                 plus >> lane & 1U, found_);
    }
  }

  CapPointers<Real> caps_;
  uint32_t count_, first_later_;
  FewCaps &found_;
  CapBits touched_ = 0;  // circles that cross another one or lie inside another cap
  CapBits unsure_ = 0;
  Clusters clusters_;
  Pairs pairs_;
  uint32_t pair_count_ = 0;
};

// The same for up to eight caps in floats, with all pairs side by side instead of cap by cap: no branch depends on
// which circles cross.
class PairSearch {
 public:
  using SomeCaps = LaneCaps<Floats>;

  PairSearch(const CapPointers<float> &caps, uint32_t count, uint32_t first_later, FewCaps &found)
      : caps_(caps),
        x_(EightFloats::load(caps.x)),
        y_(EightFloats::load(caps.y)),
        z_(EightFloats::load(caps.z)),
        b_(EightFloats::load(caps.b)),
        count_(count),
        first_later_(first_later),
        found_(found) {}

  bool run() {
    const uint32_t pair_count = count_of_pairs(count_);
    const uint8_t *const j = pairs_of_few.j[count_], *const k = pairs_of_few.k[count_];
    Relations relations;
    for (uint32_t p = 0; p < pair_count; p += Floats::lanes) {
      relate(LanePairs<Floats>(in_order(j + p), in_order(k + p)), p, relations);
    }
    const uint32_t all = static_cast<uint32_t>((UINT64_C(1) << pair_count) - 1);
    const uint32_t later = all & ~static_cast<uint32_t>((UINT64_C(1) << pairs_before_later()) - 1);
    const uint32_t cross = relations.cross & all;
    const uint32_t inside = relations.inside & all;
    const uint32_t contains = relations.contains & all;
    const uint32_t meet = cross | inside | contains;
    const uint32_t crossing = cross & later;
    if ((all & ~(meet | relations.separate)) != 0 || (crossing & ~relations.at_points) != 0) return false;
    const CapBits later_caps = ((1U << count_) - 1U) & ~((1U << first_later_) - 1U);
    found_.points = 0;
    found_.free_circles = later_caps & ~things_in(count_, cross | inside, cross | contains);
    found_.clusters = connected_sets(matrix_of(count_, meet), count_);
    return test_points(crossing);
  }

 private:
  SomeCaps in_order(const uint8_t *order) const {
    return {x_.in_order(order), y_.in_order(order), z_.in_order(order), b_.in_order(order)};
  }
  uint32_t pairs_before_later() const { return first_later_ * (2 * count_ - first_later_ - 1) / 2; }

  // Tests the points of crossing pairs against all caps. The numbers of the pairs' caps are collected in words, as
  // bytes that are read together have to be written together.
  bool test_points(uint32_t crossing) {
    found_.crossing = static_cast<uint32_t>(__builtin_popcount(crossing));
    while (crossing != 0) {
      uint64_t j = 0, k = 0;
      uint32_t count = 0;
      for (; crossing != 0 && count < Floats::lanes; crossing &= crossing - 1, ++count) {
        const uint32_t p = lowest(crossing);
        j |= static_cast<uint64_t>(pairs_of_few.j[count_][p]) << 8 * count;
        k |= static_cast<uint64_t>(pairs_of_few.k[count_][p]) << 8 * count;
      }
      if (!test_points(j, k, count)) return false;
    }
    return true;
  }
  [[gnu::always_inline]] bool test_points(uint64_t j, uint64_t k, uint32_t count) {
    uint8_t j_order[8], k_order[8];
    std::memcpy(j_order, &j, 8);
    std::memcpy(k_order, &k, 8);
    const SomeCaps u = in_order(j_order), v = in_order(k_order);
    const LanePairs<Floats> pair(u, v);
    const LaneCrossings<Floats> crossings(u, v, pair.g, pair.q);
    PointTest<Floats> minus(crossings.minus), plus(crossings.plus);
    // Nothing lies in the caps behind the last one.
#pragma GCC unroll 2
    for (uint32_t t = 0; t < PairsOfFew::most; ++t) {
      const SomeCaps cap = SomeCaps::all_of(caps_, t);
      minus.against(cap);
      plus.against(cap);
    }
    const LaneBits valid = first_lanes(count);
    const LaneBits minus_covered = minus.covered(), plus_covered = plus.covered();
    const LaneBits minus_free = minus.outside() & ~minus_covered, plus_free = plus.outside() & ~plus_covered;
    if (((minus_covered | minus_free) & (plus_covered | plus_free) & valid) != valid) return false;
    for (LaneBits either = (minus_free | plus_free) & valid; either != 0; either &= either - 1) {
      const uint32_t lane = lowest(either);
      put_points(static_cast<uint8_t>(j >> 8 * lane), static_cast<uint8_t>(k >> 8 * lane), minus_free >> lane & 1U,
                 plus_free >> lane & 1U, found_);
    }
    return true;
  }

  CapPointers<float> caps_;
  EightFloats x_, y_, z_, b_;
  uint32_t count_, first_later_;
  FewCaps &found_;
};

// False for registers of two numbers: the loops of VertexFinder take no more instructions.
template <class Lanes, class Real>
bool find_few(const CapPointers<Real> &caps, uint32_t count, uint32_t first_later, FewCaps &found) {
  if constexpr (Lanes::lanes > 2) {
    if constexpr (sizeof(Real) == sizeof(float)) {
      if (count <= PairsOfFew::most) return PairSearch(caps, count, first_later, found).run();
    }
    return FewCapsSearch<Lanes, most_few_caps / Lanes::lanes>(caps, count, first_later, found).run();
  }
  return false;
}

}  // namespace

bool find_few_in_floats(const float *x, const float *y, const float *z, const float *b, uint32_t count,
                        uint32_t first_later, FewCaps &found) {
  return find_few<Floats>(CapPointers<float>{x, y, z, b}, count, first_later, found);
}

bool find_few_in_doubles(const double *x, const double *y, const double *z, const double *b, uint32_t count,
                         uint32_t first_later, FewCaps &found) {
  return find_few<Doubles>(CapPointers<double>{x, y, z, b}, count, first_later, found);
}

}  // namespace hsp::HSP_TARGET
