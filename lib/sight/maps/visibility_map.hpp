// The visibility map of balls (Section 5.2).
#pragma once

#include "core/limits.hpp"
#include "maps/ball_scene.hpp"
#include "maps/scene_map.hpp"

namespace hsp {

struct MapLimits {
  uint32_t balls = 0;       // of the model
  uint32_t neighbours = 0;  // most balls of which discs meet any one disc and that reach higher than its centre
  uint32_t edges = 0;       // of the map
};

// Limits that suffice for most molecules. Status::range if one would be larger than max_count.
constexpr Status default_limits(uint32_t balls, MapLimits &limits) {
  if (balls > (max_count - 64) / 12) return Status::range;
  limits = {balls, balls < 256 ? balls : 256, 12 * balls + 64};
  return Status::ok;
}

// Faces in the order of SeenBalls; places of balls are those of grid order.
using VisibilityMap = SceneMap<BallScene>;

}  // namespace hsp
