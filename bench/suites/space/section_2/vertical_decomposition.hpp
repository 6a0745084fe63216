// The number of cells in the vertical decomposition of an arrangement of spheres (Theorem 2.3; Clarkson, Edelsbrunner,
// Guibas and Sharir 1990), in all of space or cube by cube (Theorem 2.4). It is counted in doubles, without the
// library, and shown beside the library's cells, which are of another kind.
//
// The plane x = t cuts the decomposition of spheres in the decomposition of circles: trapezoids between two arcs and
// two walls, with a wall at each end of a circle and at each crossing of two circles. A cell is a maximal interval of t
// in which a trapezoid exists. So it is enough to look at slices between the abscissae where anything changes. For
// disjoint spheres these abscissae are known in closed form, and the count in all of space is exact; else they are
// found by bisection to 1e-7, and the count is approximate.
#pragma once

#include <cstdint>
#include <vector>

namespace bench {

struct Sphere {
  double x, y, z, r;
};

struct DecompositionSize {
  uint64_t cells = 0;
  uint64_t free = 0;      // of these, outside all balls
  uint64_t doubtful = 0;  // slices where arcs did not come in order
};

enum class Spheres { disjoint, any };

DecompositionSize decomposition_of_space(const std::vector<Sphere> &spheres, Spheres kind);
// The sum over all cubes, of side twice the largest radius, that a ball meets. Each cube is decomposed alone.
DecompositionSize decomposition_in_cubes(const std::vector<Sphere> &spheres, Spheres kind);

// The paper's Figure 4: a row of n/2 unit spheres, and above it a row of as many spheres across. No other sphere hides
// them from each other, so that (n/2)^2 pairs of equators cross within sight.
std::vector<Sphere> figure_4(uint32_t n);

}  // namespace bench
