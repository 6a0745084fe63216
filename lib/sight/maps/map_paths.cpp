#include "maps/map_paths.hpp"

#include "core/sorting.hpp"
#include "view/depth_order.hpp"

namespace hsp {

MapPaths::MapPaths(const BallSet &balls, const VisibilityMap &map, Span<uint32_t> scratch) : map_(map) {
  uint32_t count = 0;
  for (uint32_t k = 0; k < map.scene.bodies(); ++k) {
    const uint32_t first = map.first_face_of(k);
    if (first != no_id) scratch[count++] = first;
  }
  first_face_ = scratch.part(0, count);
  sort_in_place(first_face_, [&](uint32_t f, uint32_t g) {
    return is_farther(balls, map.frame.direction, map.scene.ball_of(map.faces[f].owner),
                      map.scene.ball_of(map.faces[g].owner));
  });
}

}  // namespace hsp
