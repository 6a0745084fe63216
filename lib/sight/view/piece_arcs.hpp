// Turns the loops of a piece into arcs in the view plane.
#pragma once

#include "view/view.hpp"
#include "view/visible_piece.hpp"

namespace hsp {

// Appends the loops and arcs of a piece to the view. Arcs without room are counted, not stored.
void add_loops(const BallSet &balls, const VisiblePiece &piece, View &view);

}  // namespace hsp
