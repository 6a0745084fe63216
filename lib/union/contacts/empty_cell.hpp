// Whether nothing of a buried ball is nearest to it: its power cell is empty or lies outside of it. As no point of its
// sphere is free, the cell does not reach the sphere, so that one point of the cell tells; and where there is none,
// four other balls show it (Helly). A linear program finds the one or the other, where pair after pair of planes has a
// chord of which nothing is left. All balls are inflated as in exact/PROOFS.md, section 3.
#pragma once

#include "sphere/caps.hpp"

namespace hsp {

// Of a ball whose sphere its caps cover. False if something is nearest to it, or if the program meets a tie or takes
// too long.
[[gnu::cold]] bool has_empty_cell(const Caps &caps);

}  // namespace hsp
