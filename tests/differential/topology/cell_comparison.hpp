// Topologies against the oracles: genera and voids of each component, nesting, location. Complaints for
// complaint_about_smallest.
#pragma once

#include <cstdint>
#include <string>

#include "dual_complex.hpp"
#include "topology_run.hpp"

// Of every component b0 is 1, b1 the sum of the genera of its shells (Alexander duality), b2 its number of voids, with
// the Betti numbers of the nerve of its balls; in the given order of the balls and in `orders` random ones.
std::string betti_numbers_disagree(const oracle::Balls &balls, int orders, uint64_t seed);

// Small enough for what follows: coordinates within 2^19 steps of each other when scaled.
bool small_enough_for_dual_complex(const oracle::Balls &balls);

// Number of cells, which components lie in one cell, and which component lies in a void of which other one, are those
// of the dual complexes of all balls and of the balls of every single component.
std::string nesting_disagrees(const oracle::Balls &balls);

// The balls that line each cell are those around it in the dual complex that are exposed. For sets without ties.
std::string cell_balls_disagree(const LibraryTopology &topology, const oracle::DualComplex &complex);

// Random points, most of them on the balls' own coarse lattice where vertical rays meet ties, lie in the balls that
// contain them, or in cells as the dual complex has them.
std::string locations_disagree(const oracle::Balls &balls, int points, uint64_t seed);
