// From a set of balls on which something fails, a smaller one on which it still does.
#pragma once

#include <functional>
#include <string>

#include "lattice_ball.hpp"

// The fault of a set of balls; empty if it has none.
using Complaint = std::function<std::string(const oracle::Balls &)>;

// The complaint about the balls (exceptions count as complaints), and if there is one, a set from which no ball can be
// taken without silencing it, with its own complaint. Empty if all is well.
std::string complaint_about_smallest(const oracle::Balls &balls, const Complaint &complaint);
