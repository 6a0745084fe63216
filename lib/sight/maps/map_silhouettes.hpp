// The silhouettes of a map, as runs of arcs along each body.
#pragma once

#include "maps/stick_map.hpp"
#include "maps/visibility_map.hpp"
#include "picture/painted_paths.hpp"

namespace hsp {

// The map has to outlive this. Of balls and sticks the parameters of SilhouetteArc are those of stick_scene.hpp.
SeenSilhouettes silhouettes_of(const VisibilityMap &map);
SeenSilhouettes silhouettes_of(const StickMap &map);

}  // namespace hsp
