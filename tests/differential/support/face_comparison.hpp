// The library's areas and volume terms, face by face and ball by ball, against the faces that the oracle finds by
// slices (tests/oracle/face_quadrature.hpp).
#pragma once

#include <string>

#include "lattice_ball.hpp"

// Text about all differences of more than 1e-12 of the area of a ball's sphere, or for volumes of more than that times
// a length like the set's extent; empty if there are none. For balls in general position.
std::string faces_differ(const oracle::Balls &balls);
