// The regular triangulation of the balls and the dual complex of their union by CGAL (Debian's package libcgal-dev):
// exact combinatorics, no areas.
#pragma once

#include <cstddef>
#include <string>

#include "ball_list.hpp"

namespace bench {

// Builds the regular triangulation alone, the probe added to every radius. Returns its number of vertices; balls
// without a power cell are not among them.
size_t cgal_regular_triangulation(const support::BallList &balls, double probe);

// Builds the triangulation, and from it the alpha complex at alpha = 0 (Fixed_alpha_shape_3), which is the dual
// complex.
struct AlphaComplexSize {
  // Each regular triangle stands for one vertex of the union's boundary, each singular one for two.
  size_t boundary_vertices = 0;
};
AlphaComplexSize cgal_alpha_complex(const support::BallList &balls, double probe);

// Its version.
std::string cgal_release();

}  // namespace bench
