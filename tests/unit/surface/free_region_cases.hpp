// Regions in closed form.
#pragma once

#include "circles_in_doubles_cases.hpp"

namespace cases {

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
    if (region.arcs != c.arcs || region.cutting_arcs != c.cutting_arcs) return false;
    if (!near_modulo_turn(region.steradians(), c.steradians, 1e-13)) return false;
    if (region.steradians() < 0 || region.steradians() >= 2 * hsp::pi) return false;
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

// A source of wrong answers: contradictions are noticed.
struct Contradicting {
  struct Crossing {
    uint32_t second;
  };
  bool cross, cross_again, free;
  int angles;

  uint32_t count() const { return 3; }
  hsp::Vec3 axis(uint32_t) const { return {0, 0, 1}; }
  double height(uint32_t) const { return 0; }
  hsp::Answer crossing(uint32_t j, uint32_t k, Crossing &crossing) const {
    crossing.second = k;
    return (cross && j == 0 && k == 1) || (cross_again && j == 0) ? hsp::Answer::yes : hsp::Answer::no;
  }
  hsp::Answer contains(const Crossing &, int sign, uint32_t) const {
    return (free && sign > 0) || cross_again ? hsp::Answer::no : hsp::Answer::yes;
  }
  hsp::RegionCorner corner(const Crossing &crossing, int sign) const {
    return {0, crossing.second, sign, 1, {1, 0, 0}, 0, false};
  }
  hsp::Answer lies_inside(uint32_t, uint32_t) const { return hsp::Answer::yes; }
  bool ends_sooner(uint32_t, const hsp::RegionCorner &, const hsp::RegionCorner &, const hsp::RegionCorner &) const {
    return false;
  }
  double arc_angle(uint32_t, const hsp::RegionCorner &, const hsp::RegionCorner &) const { return angles; }
  double exterior_angle(const hsp::RegionCorner &) const { return 0; }
};

inline uint32_t contradictions_are_noticed() {
  alignas(64) unsigned char memory[4096];
  hsp::Workspace workspace(memory, sizeof memory);
  hsp::FixedVector<hsp::RegionCorner> corners(workspace.take<hsp::RegionCorner>(18));
  hsp::FixedVector<hsp::RegionArc> arcs(workspace.take<hsp::RegionArc>(18));
  hsp::FreeRegion region;
  const bool conditions[] = {
      hsp::FreeRegionFinder(Contradicting{false, false, false, 1}, corners, arcs, 3).find(region),
      hsp::FreeRegionFinder(Contradicting{true, false, false, 1}, corners, arcs, 3).find(region),
      !hsp::FreeRegionFinder(Contradicting{true, false, true, 1}, corners, arcs, 3).find(region),
      // Two arcs of one circle with the same end.
      !hsp::FreeRegionFinder(Contradicting{true, true, true, 1}, corners, arcs, 3).find(region)};
  return first_false(conditions);
}

inline constexpr Check surface_free_region[] = {{"regions_in_closed_form", regions_in_closed_form},
                                                {"ties_are_not_decided", ties_are_not_decided},
                                                {"contradictions_are_noticed", contradictions_are_noticed}};

}  // namespace cases
