// Crambin's 327 atoms as lengths in angstrom.
#pragma once

#include "ball_list.hpp"

namespace degenerate {

using Molecule = support::BallList;

// Without hydrogen atoms, radii C 1.70, N 1.55, O 1.52, S 1.80.
Molecule crambin_atoms();

}  // namespace degenerate
