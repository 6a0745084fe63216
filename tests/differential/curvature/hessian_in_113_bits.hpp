// The Hessian of V or of S = sum of sigma_i A_i times a direction, by another derivation than the library's: the first
// derivatives (T. J. Richmond 1984) arc by arc, with ends that move with their three balls, differentiated along the
// direction in numbers of 113 bits. Of the library it takes names alone: balls and signs of vertices, and the ends of
// arcs.
#pragma once

#include <vector>

#include "lattice_ball.hpp"
#include "library_run.hpp"

// direction [n][3] and the result, in lattice steps. No two of the balls may touch, and no four spheres meet in a
// point.
std::vector<double> hessian_in_113_bits(const oracle::Balls &balls, const LibraryBoundary &boundary,
                                        const std::vector<double> &sigma, bool of_volume,
                                        const std::vector<double> &direction);
