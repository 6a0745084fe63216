// Regions in closed form and of random caps against sampling, their pieces; and answers that are unknown where they
// should be.
#pragma once

#include "small_caps.hpp"

namespace cases {

inline bool found_in_doubles(SmallCaps &caps, hsp::FreeRegion &region, double amplification = 1.0) {
  return hsp::FreeRegionFinder(caps.caps, amplification, caps.corners, caps.arcs).find(region);
}

inline uint32_t random_regions_by_sampling() {
  for (uint32_t seed = 0; seed < 150; ++seed) {
    const RandomCaps random(seed);
    SmallCaps caps(random.cap, random.n);
    hsp::FreeRegion region;
    hsp::Vec3 expected{};
    const double area = caps.sample(expected);
    if (!found_in_doubles(caps, region)) return seed;
    if (caps.arcs.items().empty()) {
      if (area > 0.01) return seed;
      continue;
    }
    const hsp::Vec3 off = region.vector_area - expected;
    if (!near_modulo_turn(region.curvature, area, 0.03) || std::sqrt(dot(off, off)) > 0.03) return seed;
  }
  return all_hold;
}

// Three circles through one point, circles that touch, a cap beside a corner nearer than its error, and corners that
// are known, but not which of two comes first.
struct UnknownCase {
  uint32_t n;
  UnitCap cap[4];
  double amplification;
  bool known;
};
constexpr UnitCap octant_sides[3] = {{-1, 0, 0, 0}, {0, -1, 0, 0}, {0, 0, -1, 0}};
constexpr UnknownCase unknown_cases[] = {
    {3, {octant_sides[0], octant_sides[1], octant_sides[2]}, 1, true},
    {4, {octant_sides[0], octant_sides[1], octant_sides[2], {1, 1, 1, 0.95}}, 1, true},
    {4, {octant_sides[0], octant_sides[1], octant_sides[2], {0, 0, 1, 0.5}}, 1, true},
    {4, {octant_sides[0], octant_sides[1], octant_sides[2], {3, 4, 0, 0.6}}, 1, false},  // through (1, 0, 0)
    {4, {octant_sides[0], octant_sides[1], octant_sides[2], {3, 4, 0, 0.6 + 1e-9}}, 1, true},
    {4, {octant_sides[0], octant_sides[1], octant_sides[2], {3, 4, 0, 0.6 + 1e-9}}, 5e3, true},
    {4, {octant_sides[0], octant_sides[1], octant_sides[2], {3, 4, 0, 0.6 + 1e-9}}, 2e4, false},  // an arc too short
    {4, {octant_sides[0], octant_sides[1], octant_sides[2], {3, 4, 0, 0.6 + 1e-9}}, 1e9, false},
    {4, {octant_sides[0], octant_sides[1], octant_sides[2], {0.6, 0.64, 0.48, 0.8}}, 1, false},  // touches a side
    {4, {octant_sides[0], octant_sides[1], octant_sides[2], {3, 0, 4, 0.8}}, 1, false},          // through (0, 0, 1)
    {4, {octant_sides[0], octant_sides[1], octant_sides[2], {3, 4, 4, 0.5 * 1.2494}}, 1e12, false}};

inline uint32_t certain_or_unknown() {
  return first_failing(unknown_cases, [](const UnknownCase &c) {
    SmallCaps caps(c.cap, c.n);
    hsp::FreeRegion region;
    return found_in_doubles(caps, region, c.amplification) == c.known;
  });
}

// Two caps that are almost the same: the corner between their circles is still found.
inline uint32_t almost_the_same_circle() {
  const double apart[] = {1e-3, 1e-5, 1e-7};
  return first_failing(apart, [](double e) {
    const UnitCap cap[] = {octant_sides[0], octant_sides[1], octant_sides[2], {1, 1, 1, 0.9}, {1 + e, 1, 1 - e, 0.9}};
    SmallCaps both(cap, 5);
    SmallCaps one(cap, 4);
    hsp::FreeRegion of_both;
    hsp::FreeRegion of_one;
    return found_in_doubles(both, of_both) && found_in_doubles(one, of_one) && both.arcs.size() > one.arcs.size() &&
           near_modulo_turn(of_both.curvature, of_one.curvature, 2 * e);
  });
}

struct RegionCase {
  uint32_t n;
  UnitCap cap[6];
  double steradians;
  hsp::Vec3 vector_area;
  uint32_t arcs, cutting_arcs;
};
constexpr double octant = hsp::pi / 2;
constexpr double eighth = hsp::pi / 4;
constexpr RegionCase region_cases[] = {
    // An octant; with a cap that takes half of a spherical triangle's corner off, a hole, one that hides it.
    {3, {octant_sides[0], octant_sides[1], octant_sides[2]}, octant, {eighth, eighth, eighth}, 3, 0},
    {4,
     {octant_sides[0], octant_sides[1], octant_sides[2], {0, 0, 1, 0.5}},
     octant / 2,
     {eighth / 2 + 0.0, 0, 0},
     4,
     1},
    {4,
     {octant_sides[0], octant_sides[1], octant_sides[2], {1, 1, 1, 0.96}},
     octant - 2 * hsp::pi * 0.04,
     {0, 0, 0},
     4,
     1},
    {4, {octant_sides[0], octant_sides[1], octant_sides[2], {1, 1, 1, 0.1}}, 0, {0, 0, 0}, 0, 0},
    {4, {octant_sides[0], octant_sides[1], octant_sides[2], {-1, -1, -1, 0.5}}, octant, {eighth, eighth, eighth}, 3, 0},
    {5,
     {octant_sides[0], octant_sides[1], octant_sides[2], {1, 1, 1, 0.96}, {1, 1, 1, 0.98}},
     octant - 2 * hsp::pi * 0.04,
     {0, 0, 0},
     4,
     1},
    // Two caps at two corners leave two arcs on the side between.
    {5,
     {octant_sides[0], octant_sides[1], octant_sides[2], {0, 0, 1, 0.9}, {1, 0, 0, 0.9}},
     octant - 0.2 * octant,
     {0, 0, 0},
     5,
     2}};

inline uint32_t regions_in_closed_form() {
  return first_failing(region_cases, [](const RegionCase &c) {
    SmallCaps caps(c.cap, c.n);
    hsp::FreeRegion region;
    if (!found_in_doubles(caps, region)) return false;
    uint32_t cutting_arcs = 0;
    for (const hsp::RegionArc &arc : caps.arcs.items()) cutting_arcs += arc.circle >= 3 ? 1U : 0U;
    if (caps.arcs.size() != c.arcs || cutting_arcs != c.cutting_arcs) return false;
    if (!near_modulo_turn(region.curvature, c.steradians, 1e-13)) return false;
    const hsp::Vec3 off = region.vector_area - c.vector_area;
    return c.vector_area.y == 0 || dot(off, off) < 1e-26;
  });
}

// Circles through one point, circles that touch and circles that are equal: doubles are silent.
struct TiedCase {
  uint32_t n;
  UnitCap cap[6];
};
constexpr TiedCase tied_cases[] = {
    {4, {octant_sides[0], octant_sides[1], octant_sides[2], {-1, 0, 0, 0}}},
    {4, {octant_sides[0], octant_sides[1], octant_sides[2], {1, -1, 0, 0}}},
    {5, {octant_sides[0], octant_sides[1], octant_sides[2], {1, -1, 0, 0}, {1, -1, 0, 0}}},
    {5, {octant_sides[0], octant_sides[1], octant_sides[2], {1, -1, 0, 0}, {-1, 1, 0, 0}}},
    {6, {octant_sides[0], octant_sides[1], octant_sides[2], {1, -1, 0, 0}, {0, 1, -1, 0}, {1, 0, -1, 0}}},
    {4, {octant_sides[0], octant_sides[1], octant_sides[2], {1, 1, 1, 0.5773502691896257}}}};

inline uint32_t ties_are_not_decided() {
  return first_failing(tied_cases, [](const TiedCase &c) {
    SmallCaps caps(c.cap, c.n);
    hsp::FreeRegion region;
    return !found_in_doubles(caps, region);
  });
}

// Pieces of an octant that caps cut, and the holes in them.
struct PiecesCase {
  uint32_t n;
  UnitCap cap[6];
  uint32_t pieces, loops;
  uint32_t most_loops;  // of one piece
  bool known = true;
};
constexpr PiecesCase pieces_cases[] = {
    {3, {octant_sides[0], octant_sides[1], octant_sides[2]}, 1, 1, 1},
    // A hole in the middle; a cap over the middles of all sides leaves three corners; one of these has a hole, which
    // doubles do not find.
    {4, {octant_sides[0], octant_sides[1], octant_sides[2], {1, 1, 1, 0.96}}, 1, 2, 2},
    {4, {octant_sides[0], octant_sides[1], octant_sides[2], {1, 1, 1, 0.8}}, 3, 3, 1},
    {5, {octant_sides[0], octant_sides[1], octant_sides[2], {1, 1, 1, 0.8}, {1, 0.12, 0.12, 0.9986}}, 3, 4, 2, false},
    // Two holes of one piece, the other piece has none.
    {6,
     {octant_sides[0],
      octant_sides[1],
      octant_sides[2],
      {1, 0, 1, 0.72},
      {0.2, 1, 0.2, 0.9995},
      {0.3, 1, 0.1, 0.99995}},
     1,
     3,
     3},
    {4, {octant_sides[0], octant_sides[1], octant_sides[2], {1, 1, 1, 0.1}}, 0, 0, 0}};

inline uint32_t pieces_and_loops() {
  return first_failing(pieces_cases, [](const PiecesCase &c) {
    SmallCaps caps(c.cap, c.n);
    hsp::FreeRegion region;
    if (!found_in_doubles(caps, region)) return false;
    const hsp::Span<hsp::RegionArc> arcs = caps.arcs.items();
    int32_t characteristic = 0;
    if (hsp::find_pieces(arcs, characteristic) != c.known) return false;
    if (!c.known) return true;
    const double area = region.curvature + 2 * hsp::pi * characteristic;
    if (!(area >= 0.0 && area <= octant + 1e-14)) return false;
    uint32_t pieces = 0;
    uint32_t loops = 0;
    uint32_t most_loops = 0;
    for (uint32_t piece = 0; piece < arcs.size(); ++piece) {
      if (arcs[arcs[piece].next].loop != arcs[piece].loop) return false;
      if (arcs[piece].piece != piece) continue;
      ++pieces;
      uint32_t own = 0;
      for (uint32_t loop = 0; loop < arcs.size(); ++loop) {
        if (arcs[loop].loop == loop && arcs[loop].piece == piece) ++own;
      }
      loops += own;
      if (own > most_loops) most_loops = own;
    }
    return pieces == c.pieces && loops == c.loops && most_loops == c.most_loops;
  });
}

inline constexpr Check surface_free_region[] = {{"random_regions_by_sampling", random_regions_by_sampling},
                                                {"certain_or_unknown", certain_or_unknown},
                                                {"almost_the_same_circle", almost_the_same_circle},
                                                {"regions_in_closed_form", regions_in_closed_form},
                                                {"ties_are_not_decided", ties_are_not_decided},
                                                {"pieces_and_loops", pieces_and_loops}};

}  // namespace cases
