#include "visibility/map_check.hpp"

#include "visibility/map_laws.hpp"

namespace hsp {

MapViolation check_map(const VisibilityMap &map, Span<uint32_t> scratch) {
  return MapLaws<VisibilityMap>(map, scratch).run();
}

}  // namespace hsp
