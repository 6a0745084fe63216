// The power diagram of a union of balls (power distance |x - c|^2 - r^2): which cells meet within the union, exactly,
// and by sampling the volumes of the cells and the areas between two of them.
#pragma once

#include <array>
#include <cstdint>
#include <set>
#include <vector>

#include "lattice_ball.hpp"

namespace oracle {

// The simplices of the dual complex of the balls inflated by infinitesimals as in sphere_predicates.hpp: balls, edges,
// triangles and tetrahedra, each by ascending ids. The brute-force boundary gives the simplices of its faces, free
// circles and free vertices. A tetrahedron belongs to the complex if the point of equal power of its four balls lies in
// them and no fifth ball has less power there; every four balls and every fifth are tried. With a simplex go its sides.
// Centres within 2^19 steps of each other and radii of at most 2^20 steps.
struct DualSimplices {
  std::set<uint32_t> balls;
  std::set<std::array<uint32_t, 2>> edges;
  std::set<std::array<uint32_t, 3>> triangles;
  std::set<std::array<uint32_t, 4>> tetrahedra;
};
DualSimplices dual_simplices(const Balls &balls);

// The area where the cells of balls a and b meet within both balls, by parallel chords of the disk that the circle of
// the two spheres bounds. The spheres must cross.
double contact_area_by_slices(const Balls &balls, uint32_t a, uint32_t b, uint32_t slices);

// The volumes of all cells within their balls, by counting points of a cubic grid of points^3 in the box around each
// ball.
std::vector<double> cell_volumes_by_points(const Balls &balls, uint32_t points);

}  // namespace oracle
