// The connected pieces of a free region inside a spherical triangle: its loops, and which of them bound one piece.
//
// A loop is the border of a piece or of a hole in one. Put K for the sum of its arcs' heights * angles, minus its
// exterior angles: by Gauss and Bonnet what the loop leaves on its region's side has the area 2 pi + K. A piece is
// smaller than the triangle, so K < 0; the outside of a hole is larger than a half sphere, so K > 0.
#pragma once

#include "sphere/caps.hpp"
#include "surface/free_region.hpp"

namespace hsp {

// Sets `loop` and `piece` of all arcs. False if a hole lies in no piece, or in several.
bool find_pieces(const Caps &caps, Span<const RegionCorner> corners, Span<RegionArc> arcs);

}  // namespace hsp
