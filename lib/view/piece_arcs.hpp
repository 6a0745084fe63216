// From the loops of a piece to arcs in the view plane.
#pragma once

#include "view/visible_piece.hpp"
#include "view/view.hpp"

namespace hsp {

// Appends the loops and arcs of a piece. Arcs that do not fit are counted.
void add_loops(const BallSet &balls, const FrontPiece &piece, ViewStructure &view);

}  // namespace hsp
