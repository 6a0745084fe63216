// The invariants of topologies, which are written in C, over the oracles' balls. Complaints for
// complaint_about_smallest.
#pragma once

#include <string>

#include "lattice_ball.hpp"

// The first invariant of the topology that does not hold, or nothing.
std::string topology_invariant_broken(const oracle::Balls &balls);

// Whether some of four orders of the balls give another topology.
std::string topology_orders_disagree(const oracle::Balls &balls);
