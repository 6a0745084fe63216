// How a union of balls is shared out by power distance |x - c|^2 - r^2: which balls' cells meet, exactly, and how large
// cells and the pieces between them are, by sampling.
#pragma once

#include <array>
#include <cstdint>
#include <set>
#include <vector>

#include "lattice_ball.hpp"

namespace oracle {

// The simplices of the dual complex of the balls inflated by infinitesimals as in sphere_predicates.hpp: ball, edge,
// triangle, tetrahedron, each ascending. It is the closure of what the boundary shows (whole spheres, free circles and
// free vertices) and of the points of equal power of four balls that lie in them and have no less power to a fifth.
// Every four balls and every fifth are tried. Centres within 2^19 steps of each other and radii of at most 2^20 steps.
struct DualSimplices {
  std::set<uint32_t> balls;
  std::set<std::array<uint32_t, 2>> edges;
  std::set<std::array<uint32_t, 3>> triangles;
  std::set<std::array<uint32_t, 4>> tetrahedra;
};
DualSimplices dual_simplices(const Balls &balls);

// The area where the cells of balls a and b meet, by slices of their circle's disk. Their spheres must cross.
double contact_area_by_slices(const Balls &balls, uint32_t a, uint32_t b, uint32_t slices);

// The volumes of all cells, from points in rows of that many in the box around each ball.
std::vector<double> cell_volumes_by_points(const Balls &balls, uint32_t points);

}  // namespace oracle
