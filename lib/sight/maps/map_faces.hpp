// Loops and faces from linked half-edges, and what proves that they fit together.
#pragma once

#include "core/disjoint_sets.hpp"
#include "maps/disc_grid.hpp"
#include "maps/visibility_map.hpp"

namespace hsp {

class MapFaceFinder {
 public:
  void carve(Workspace &workspace, const MapLimits &limits);

  // Fills loops, faces and components. False where something does not fit:
  //   half-edges do not chain up to loops;
  //   the labels of a loop's edges name two balls;
  //   a loop has no labels, and nowhere along it is it certain which ball is behind;
  //   beside a short edge another ball is behind a silhouette than the loop says;
  //   a hole lies in no face of its owner;
  //   the highest point of a ball is seen, but the ball has no face;
  //   the numbers contradict Euler's formula.
  // And unless `complete`, which says that no arc of a silhouette may be missing, if behind the middle of some
  // silhouette cannot be what the loop there says.
  bool find(const DiscGrid &grid, bool complete, VisibilityMap &map);

  // Memory that is free between calls; [2 edges + 1] and [edges].
  Span<uint32_t> scratch() { return scratch_; }
  Span<uint32_t> more_scratch() { return parent_; }

 private:
  bool trace_loops(const DiscGrid &grid, VisibilityMap &map);
  bool trace_loop(uint32_t first, VisibilityMap &map);
  bool name_owner(const DiscGrid &grid, MapLoop &loop, const VisibilityMap &map) const;
  void count_components(VisibilityMap &map);
  void add_outer_loops(VisibilityMap &map);
  bool tops_have_faces(const DiscGrid &grid, const VisibilityMap &map) const;

  Span<uint32_t> parent_;      // [edges] of vertices
  Span<uint32_t> first_face_;  // [balls] as the map's
  Span<uint32_t> scratch_;     // [2 edges + 1]
};

}  // namespace hsp
