// How many cells the vertical decomposition of an arrangement of spheres has (Theorem 2.3; Clarkson, Edelsbrunner,
// Guibas and Sharir 1990), in all of space or cube by cube (Theorem 2.4): counted in doubles, to be shown beside the
// cells of the library, which are of another kind.
//
// The plane x = t cuts the decomposition in that of circles: trapezoids between two arcs and two walls, and a wall
// stands at each end of a circle and at each crossing of two. A cell is a maximal interval of t in which a trapezoid
// exists. So it is enough to look at slices between the abscissae where anything happens. Of disjoint spheres these are
// known in closed form and the count in all of space is exact; else they are found by bisection to 1e-7, and the count
// is approximate.
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
// In each cube of twice the largest radius that a ball meets, with nothing beyond its sides.
DecompositionSize decomposition_in_cubes(const std::vector<Sphere> &spheres, Spheres kind);

// The paper's Figure 4: n/2 unit spheres one below the other, and as many above them and across, which are seen past
// each other from everywhere: (n/2)^2 pairs of equators cross within sight.
std::vector<Sphere> figure_4(uint32_t n);

}  // namespace bench
