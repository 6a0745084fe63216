// Rules for the library's boundary of any set of balls.
#pragma once

#include <string>

#include "degenerate_set.hpp"
#include "library_run.hpp"
#include "smallest_failing.hpp"

namespace degenerate {

Topology topology_of(const LibraryBoundary &boundary);
Topology topology_of(const oracle::BoundaryRecord &record);

// That of the closed balls as given, in rational numbers; the balls must be small enough for the oracle.
Topology topology_of_nerve(const oracle::Balls &balls);
bool small_enough_for_nerve(const oracle::Balls &balls);

std::string to_text(const Topology &topology);

// Four input orders give one boundary, and areas and volumes of single balls to the last bit.
std::string orders_disagree(const oracle::Balls &balls);

// So do copies moved by lattice vectors, to the corners of the lattice too.
std::string places_disagree(const oracle::Balls &balls);

// A set that is scaled to fill the lattice has the same boundary, and areas and volumes in proportion.
std::string scales_disagree(const oracle::Balls &balls);

// Permuted and reflected axes, which change the order of ties, leave the topology, and areas and volumes up to
// rounding.
std::string axes_disagree(const oracle::Balls &balls);

// Nothing changes with every ball twice, or with a ball of half its size in the middle of every ball; and the union
// does not with balls that touch every ball from inside.
std::string copies_disagree(const oracle::Balls &balls);

// Areas of single balls, total area and volume are those of quadrature over slices, to 1e-12 of the surface of the
// largest ball (more where nearly concentric balls are beyond the oracle's digits) and of the totals.
std::string slices_disagree(const oracle::Balls &balls);

// The topology is that of the nerve.
std::string nerve_disagrees(const oracle::Balls &balls);

// The boundary is that of brute force, record by record.
std::string brute_force_disagrees(const oracle::Balls &balls);

}  // namespace degenerate
