#include "maps/map_check.hpp"

#include "maps/map_laws.hpp"

namespace hsp {

MapViolation check_map(const VisibilityMap &map, Span<uint32_t> scratch) {
  return MapLaws<VisibilityMap>(map, scratch).run();
}

}  // namespace hsp
