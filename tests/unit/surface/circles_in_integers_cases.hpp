// The same regions from integers as from doubles, and answers where doubles have none.
#pragma once

#include "circles_in_doubles_cases.hpp"
#include "surface/circles_in_integers.hpp"

namespace cases {

inline bool found_in_integers(SmallCaps &caps, hsp::FreeRegion &region) {
  const hsp::CirclesInIntegers circles(caps.caps);
  return hsp::FreeRegionFinder(circles, caps.corners, caps.arcs, 3).find(region);
}

inline uint32_t same_regions_as_in_doubles() {
  for (uint32_t seed = 1000; seed < 1200; ++seed) {
    const RandomCaps random(seed);
    SmallCaps caps(random.cap, random.n);
    hsp::FreeRegion exact;
    hsp::FreeRegion expected;
    if (!found_in_doubles(caps, expected) || !found_in_integers(caps, exact)) return seed;
    if (exact.arcs != expected.arcs || exact.cutting_arcs != expected.cutting_arcs) return seed;
    const hsp::Vec3 off = exact.vector_area - expected.vector_area;
    if (!near_modulo_turn(exact.steradians(), expected.steradians(), 1e-6) || dot(off, off) > 1e-12) return seed;
  }
  return all_hold;
}

// Circles through one point, circles that touch and circles that are equal have the area of the limit.
struct TiedCase {
  uint32_t n;
  UnitCap cap[6];
  double steradians;
};
constexpr double octant = hsp::pi / 2;
constexpr TiedCase tied_cases[] = {
    {4, {octant_sides[0], octant_sides[1], octant_sides[2], {-1, 0, 0, 0}}, octant},
    {4, {octant_sides[0], octant_sides[1], octant_sides[2], {1, -1, 0, 0}}, octant / 2},  // halves it
    {5, {octant_sides[0], octant_sides[1], octant_sides[2], {1, -1, 0, 0}, {1, -1, 0, 0}}, octant / 2},
    {5, {octant_sides[0], octant_sides[1], octant_sides[2], {1, -1, 0, 0}, {-1, 1, 0, 0}}, 0},
    {6, {octant_sides[0], octant_sides[1], octant_sides[2], {1, -1, 0, 0}, {0, 1, -1, 0}, {1, 0, -1, 0}}, octant / 6},
    {4, {octant_sides[0], octant_sides[1], octant_sides[2], {1, 1, 1, 0.5773502691896257}}, 0}};  // through the corners

inline uint32_t ties_are_decided() {
  return first_failing(tied_cases, [](const TiedCase &c) {
    SmallCaps caps(c.cap, c.n);
    hsp::FreeRegion region;
    hsp::FreeRegion in_doubles;
    return found_in_integers(caps, region) && near_modulo_turn(region.steradians(), c.steradians, 1e-3) &&
           !found_in_doubles(caps, in_doubles);
  });
}

inline constexpr Check surface_circles_in_integers[] = {{"same_regions_as_in_doubles", same_regions_as_in_doubles},
                                                        {"ties_are_decided", ties_are_decided}};

}  // namespace cases
