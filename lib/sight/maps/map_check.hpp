// The invariants of a visibility map, checked from its records alone. For fuzzers, careful callers, and whoever changes
// the code.
#pragma once

#include "maps/visibility_map.hpp"

namespace hsp {

// Numbered as in hardsphere.h.
enum class MapInvariant : uint32_t {
  none = 0,
  vertices = 1,    // their kinds tell how many edges they have, and they name a half-edge that leaves them
  edges = 2,       // parameters ascend by a whole turn at most, and the balls of both ends are those of the edge
  successors = 3,  // every half-edge has one successor, which begins where it ends, and one predecessor
  loops = 4,       // the balls named around a loop are its owner
  faces = 5,       // one outer loop each, but for the unbounded one, of a positive area; the holes have negative ones;
                   // those of one owner follow each other; the unbounded one has holes where there are balls
  euler = 6,       // V - E + F = 1 + C
  positions = 7,   // edges end at their vertices, and every T lies on its silhouette
  areas = 8,       // a face has the area of its loops, and all together that within the outermost edges; those of one
                   // ball are at least 0 and at most its disc
  sides = 9,       // what the sides of an edge show has its front at the middle of the edge, not before it
};

// The first violated invariant, and the id of the vertex, edge, half-edge, loop or face where it fails; no_id where
// none does.
struct MapViolation {
  MapInvariant invariant = MapInvariant::none;
  uint32_t id = no_id;
};

// scratch [2 edges + 1]. O(size).
MapViolation check_map(const VisibilityMap &map, Span<uint32_t> scratch);

}  // namespace hsp
