#include "maps/region_faces.hpp"

#include <initializer_list>

#include "maps/face_nesting.hpp"
#include "maps/map_laws.hpp"

namespace hsp {

bool find_faces(StickRegions &regions) {
  for (uint32_t &first : regions.first_face) first = no_id;
  regions.faces.clear();
  regions.faces.push({no_id, no_id, 0.0});
  for (const bool background : {true, false}) {
    for (uint32_t l = 0; l < regions.loops.size(); ++l) {
      MapLoop &loop = regions.loops[l];
      if ((loop.owner == no_id) != background || !(loop.area > 0.0)) continue;
      loop.face = regions.faces.size();
      if (!background && regions.first_face[loop.owner] == no_id) regions.first_face[loop.owner] = loop.face;
      regions.faces.push({loop.owner, l, loop.area});
    }
  }
  return add_holes(regions);
}

MapViolation check_regions(const StickRegions &regions, Span<uint32_t> scratch) {
  return MapLaws<StickRegions>(regions, scratch).run();
}

}  // namespace hsp
