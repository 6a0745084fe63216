// The library's areas and volume terms, face by face and ball by ball, against the faces that slices find.
#pragma once

#include <string>

#include "lattice_ball.hpp"

// Differences of more than 1e-12 of a ball's sphere (areas), or of that times the set's extent (volumes); empty if
// there are none. For balls in general position.
std::string faces_differ(const oracle::Balls &balls);
