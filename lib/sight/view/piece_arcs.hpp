// From the loops of a piece to arcs in the view plane.
#pragma once

#include "view/view.hpp"
#include "view/visible_piece.hpp"

namespace hsp {

// Appends the loops and arcs of a piece. Arcs that do not fit are counted.
void add_loops(const BallSet &balls, const VisiblePiece &piece, View &view);

}  // namespace hsp
