// The visibility map of balls and sticks, with the curves of stick_scene.hpp. For each body that is seen there is also
// the first of its loops, in an order for painting.
#pragma once

#include "maps/map_paths.hpp"
#include "maps/stick_scene.hpp"

namespace hsp {

// Faces farthest body first, and each body at its own rank.
struct StickMap : SceneMap<StickScene> {
  bool exist = false;
  Span<uint32_t> first_loop;  // [owners] indices in the order of loops

  // As a source of paths (map_paths.hpp): one for each body that is seen, of its loops in their order.
  const StickMap &map() const { return *this; }
  uint32_t owner_of(uint32_t path) const { return loops[loop_order[first_loop[path]]].owner; }
  template <class Visit>
  void visit_path(uint32_t path, Visit visit) const {
    const uint32_t owner = owner_of(path);
    for (uint32_t k = first_loop[path]; k < loops.size() && loops[loop_order[k]].owner == owner; ++k) {
      visit(loops[loop_order[k]].first_half_edge);
    }
  }
  static bool is_plain(const void *source, uint32_t path) {
    const StickMap &map = *static_cast<const StickMap *>(source);
    return !map.scene.is_ball(map.owner_of(path));
  }
  void carve(Workspace &workspace, const StickLimits &limits) {
    MapRecords::carve(workspace, limits.edges);
    first_loop = workspace.take<uint32_t>(limits.balls + 2 * static_cast<uint64_t>(limits.sticks));
  }
  void clear() {
    MapRecords::clear();
    exist = false;
    perturbation = 0.0;
  }
};

// Each edge is drawn once: a contour by its body, a crease or half circle by the nearer body. The map has to outlive
// them.
inline PaintedPaths paths_of(const StickMap &map) {
  return {map.frame, map.owners, &map, MapPathFunctions<StickMap>::functions};
}

}  // namespace hsp
