// Shrinks a set of balls on which a check fails to a smaller set on which it still fails.
#pragma once

#include <functional>
#include <string>

#include "lattice_ball.hpp"

// The fault of a set of balls; empty if it has none.
using Complaint = std::function<std::string(const oracle::Balls &)>;

// The complaint about the balls (an exception counts as a complaint), followed by a subset that is complained about
// too, but no longer if any one ball is left out, and the complaint about this subset. Empty if all is well.
std::string complaint_about_smallest(const oracle::Balls &balls, const Complaint &complaint);
