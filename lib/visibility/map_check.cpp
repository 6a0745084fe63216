#include "visibility/map_check.hpp"

#include "visibility/map_laws.hpp"

namespace hsp {

MapViolation check_map(const VisibilityMap &map, Span<uint32_t> scratch) {
  MapBodies bodies{map.balls.size(), 0.0};
  for (const SeenBall &ball : map.balls) bodies.largest = ball.r > bodies.largest ? ball.r : bodies.largest;
  return MapLaws<VisibilityMap>(map, bodies, scratch).run();
}

}  // namespace hsp
