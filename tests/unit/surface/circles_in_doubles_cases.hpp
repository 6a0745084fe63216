// Regions of random caps against sampling, and answers that are unknown where they should be.
#pragma once

#include "small_caps.hpp"
#include "surface/circles_in_doubles.hpp"

namespace cases {

inline bool found_in_doubles(SmallCaps &caps, hsp::FreeRegion &region, double amplification = 1.0) {
  const hsp::CirclesInDoubles circles(caps.caps, amplification);
  return hsp::FreeRegionFinder(circles, caps.corners, caps.arcs, 3).find(region);
}

inline uint32_t random_regions_by_sampling() {
  for (uint32_t seed = 0; seed < 150; ++seed) {
    const RandomCaps random(seed);
    SmallCaps caps(random.cap, random.n);
    hsp::FreeRegion region;
    hsp::Vec3 expected{};
    const double area = caps.sample(expected);
    if (!found_in_doubles(caps, region)) return seed;
    if (region.arcs == 0) {
      if (area > 0.01) return seed;
      continue;
    }
    const hsp::Vec3 off = region.vector_area - expected;
    if (!near_modulo_turn(region.steradians(), area, 0.03) || std::sqrt(dot(off, off)) > 0.03) return seed;
  }
  return all_hold;
}

// Three circles through one point, circles that touch, and a cap beside a corner nearer than its error.
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
    return found_in_doubles(both, of_both) && found_in_doubles(one, of_one) && of_both.arcs > of_one.arcs &&
           near_modulo_turn(of_both.steradians(), of_one.steradians(), 2 * e);
  });
}

inline constexpr Check surface_circles_in_doubles[] = {{"random_regions_by_sampling", random_regions_by_sampling},
                                                       {"certain_or_unknown", certain_or_unknown},
                                                       {"almost_the_same_circle", almost_the_same_circle}};

}  // namespace cases
