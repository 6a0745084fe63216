// Whether a buried ball has no share of the union: its power cell is empty or lies outside the ball. As no point of its
// sphere is free, the cell does not meet the sphere, so that one point of the cell tells; and if the cell is empty,
// four other balls show it (Helly). A linear program finds such a point or four such balls. It is used after many pairs
// of planes had chords of which nothing is left. All balls are inflated as in exact/PROOFS.md, section 3.
#pragma once

#include "sphere/caps.hpp"

namespace hsp {

// caps: of a ball whose sphere they cover. True if it certainly has no share. False if it has one, or if the program
// meets a tie or takes too long.
[[gnu::cold]] bool has_empty_cell(const Caps &caps);

}  // namespace hsp
