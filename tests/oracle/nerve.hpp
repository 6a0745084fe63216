// Topology of a union of closed balls from their nerve: which balls have a common point.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lattice_ball.hpp"

namespace oracle {

// Do the closed balls, as given, have a common point? At most four balls, whose centres differ by at most 100 steps in
// every coordinate and whose radii are at most 100 steps (so that 128 bits hold every number), else std::out_of_range.
//
// The function max_i |x - c_i|^2 - w_i has one minimum; it lies at the radical centre of some affinely independent
// subset of the balls, within the simplex of their centres, and there the subset attains the maximum (Caratheodory's
// theorem on the gradients). The balls meet exactly if the minimum is not positive.
bool have_common_point(const std::vector<LatticeBall> &balls);

// The Betti numbers b0, b1, b2 of the union (components, tunnels, voids): those of the nerve, because balls are
// convex. Ranks modulo 2 suffice: a subset of space has no torsion.
std::array<int64_t, 3> nerve_betti_numbers(const Balls &balls);

}  // namespace oracle
