// The lines between the strands of a stick, as far as a map shows that stick. In a map a stick of several strands is
// one body, as thick as all of them: nothing behind it is seen between strands.
#pragma once

#include "maps/stick_scene.hpp"

namespace hsp {

// Calls visitor(arc, true, false) for each visible piece, from the foot on: pieces of both sides of each strand, except
// a side that is the stick's contour; of a dashed strand as far as its dashes go. Calls nothing for a path that is none
// of a stick. O(e (1 + p)) for each side, with e edges around the path and p pieces.
void visit_strand_lines(const StickMap &map, uint32_t path, const ArcVisitor &visitor);

}  // namespace hsp
