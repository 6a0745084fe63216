// Balls seen along the z axis by CGAL's envelopes of surfaces (Debian's package libcgal-dev): exact, with algebraic
// numbers.
#pragma once

#include <cstddef>
#include <string>

#include "ball_list.hpp"

namespace bench {

// Builds the upper envelope of the spheres. Centres and radii are rounded to 1e-3 first, as files have them. Returns
// the number of its faces, the unbounded one included.
size_t cgal_envelope_faces(const support::BallList &balls);

// Its version.
std::string cgal_envelope_release();

}  // namespace bench
