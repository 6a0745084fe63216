// Whether nothing is left of a ball's power cell: no point is nearer to the ball than to each of some others, in power
// distance, all of them inflated as in exact/PROOFS.md, section 3. Four of the others show it (Helly); a linear program
// finds these, where every pair of planes has a chord of which nothing is left.
#pragma once

#include "sphere/caps.hpp"

namespace hsp {

// True if it is known to be empty. False if it is not, or if the program meets a tie or takes too long.
[[gnu::cold]] bool is_empty_cell(const Caps &caps);

}  // namespace hsp
