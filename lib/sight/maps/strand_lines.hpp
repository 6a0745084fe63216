// The lines between the strands of a stick, as far as they are seen of it in a map. There it is one body, as thick as
// all of them, and nothing behind it is seen between strands.
#pragma once

#include "maps/stick_scene.hpp"

namespace hsp {

// Calls visitor(arc, true, false) for each visible piece, from the foot on: of a strand both sides but the stick's own
// contour, and of a dashed one as far as its dashes go. The path is one of a stick, or nothing is called.
// O(e (1 + p)) for each side, for e edges around the path and p pieces.
void visit_strand_lines(const StickMap &map, uint32_t path, const ArcVisitor &visitor);

}  // namespace hsp
