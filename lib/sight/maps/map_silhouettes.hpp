// The silhouettes of a map, as runs of arcs along each ball.
#pragma once

#include "maps/visibility_map.hpp"
#include "picture/painted_paths.hpp"

namespace hsp {

// The map has to outlive this.
SeenSilhouettes silhouettes_of(const VisibilityMap &map);

}  // namespace hsp
