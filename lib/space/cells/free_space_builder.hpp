// Cuts free space into cells.
#pragma once

#include "cells/cube_contacts.hpp"
#include "cells/facet_overlay.hpp"
#include "cells/free_space.hpp"
#include "cells/free_space_check.hpp"

namespace hsp {

class FreeSpaceBuilder : public Limited<FreeSpaceLimits> {
 public:
  void carve(Workspace &workspace, const FreeSpaceLimits &limits, bool with_portals = false);

  // Status::capacity if a limit is too small; needed() then tells what suffices, with 0 for what is not known yet.
  // Status::check would mean that cells disagree, and cannot happen. Status::stopped if patience has ended.
  Status build(const CubeGrid &grid, Patience patience = Patience());

  const FreeSpace &structure() const { return structure_; }
  // For tests, which damage it.
  FreeSpace &structure() { return structure_; }
  FreeSpaceScratch scratch() { return {cell_, structure_.region_sets, touched_}; }

 private:
  // A cube, and the cubes or runs on its six sides.
  struct Cube {
    uint32_t number;
    CubeFrame frame;
    uint32_t neighbour[cube_sides];  // a cube of the cover, or no_id
    uint32_t run[cube_sides];        // the run on that side if there is no such cube
  };

  void add_runs(Patience &patience);
  Status add_cube(const BallSet &balls, const Cube &cube, Patience &patience);
  void add_parts(const Cube &cube);
  void touch_run(const Cube &cube, uint32_t side, uint32_t first, uint32_t first_cell);
  Status touch_cubes(const BallSet &balls, const Cube &cube);
  Cube surroundings(uint32_t number);
  void note(uint32_t &needed, uint64_t count) const { needed = larger_count(needed, clamped_count(count)); }
  bool gather_needs();
  void link_cells(Patience &patience);
  void find_regions(Patience &patience);

  FreeSpace structure_;
  PowerCell cell_;
  CubeContacts contacts_;
  FacetOverlay overlay_;
  SideFacets kept_;                // facets on upper sides, for the cubes that follow
  SideFacets open_;                // facets of one cube on its lower sides
  Span<uint32_t> first_kept_;      // [cubes + 1]
  Span<uint8_t> touched_;          // [corners of one cell] marks the parts that a run touches
  uint32_t beside_[cube_sides]{};  // for each side the first cube that is not before the last cube's neighbour there
  bool contacts_known_ = true;
};

}  // namespace hsp
