// The library's areas and volume terms, face by face and ball by ball, against the faces that slices find.
#ifndef HARDSPHERE_TESTS_AGAINST_ORACLE_FACE_COMPARISON_HPP
#define HARDSPHERE_TESTS_AGAINST_ORACLE_FACE_COMPARISON_HPP

#include <string>

#include "lattice_ball.hpp"

/// What differs by more than 1e-12 of a ball's sphere (areas), or of that times the set's extent (volumes); empty if
/// nothing does. For balls in general position.
std::string faces_differ(const oracle::Balls &balls);

#endif
