// Regions of free space as the balls leave it, each with its maxima and the shells that bound it, its area and volume.
// The balls may have been grown by a probe: then these are the regions that its centre gets about in.
//
// The tree of merges has the regions: they are the classes at the level 0. The boundary has their surface. A shell
// belongs to the region that a way up from one of its points leads to, if it is certain: the first step of the way has
// all balls nearby behind it and leads more than three lattice steps above the boundary. From a point where two regions
// touch no step does.
#pragma once

#include "boundary/boundary.hpp"
#include "pores/ascent.hpp"
#include "pores/pores_builder.hpp"

namespace hsp {

struct PoreRegion {
  uint32_t maximum;         // the highest one, or pore_outside
  uint32_t origin = no_id;  // a ball of the grid with a face on it
  uint32_t maxima = 0, shells = 0;
  double area = 0.0;
  double plug_area = 0.0;  // of that the part on plugs
  double volume = 0.0;     // infinite of the outside without a box
  WindingLattice lattice{};
  // Of others, as claim() has it.
  uint32_t owner = no_id;
  bool is_claimed = false;
  bool is_shared = false;
  // Whether it goes on for ever.
  bool is_accessible() const { return maximum == pore_outside || lattice.rank > 0; }
};

class RegionFinder {
 public:
  void carve(Workspace &workspace, const PoreLimits &limits);
  // pores: all above a floor of 0 or less. periodic: null without a box. first_plug: the caller's balls are plugs from
  // that one on. pores.joined() becomes that of the level 0.
  // Status::range: of a shell no point is known to lead anywhere, or as locate(). Status::check cannot happen.
  // Status::stopped: more is not allowed.
  Status find(PoresBuilder &pores, const BallsAround &balls, const Boundary &boundary, const PeriodicUnion *periodic,
              int64_t floor, uint32_t first_plug, Patience patience = Patience());
  // The region of a maximum of the same pores, or of the outside, while pores.joined() is as it was; no_id if it is in
  // none.
  uint32_t region_of(const PoresBuilder &pores, uint32_t maximum) const {
    const uint32_t node = node_of(maximum);
    if (node >= pores.joined().size() || (node == 0 && !has_outside_)) return no_id;
    return pores.joined().component(node) - (has_outside_ ? 0 : 1);
  }
  // Notes that something of the owner's is in a region.
  void claim(uint32_t region, uint32_t owner) {
    PoreRegion &claimed = regions_[region];
    if (!claimed.is_claimed) claimed.owner = owner;
    if (claimed.owner != owner) claimed.is_shared = true;
    claimed.is_claimed = true;
  }
  void forget() { regions_.clear(); }

  // The outside first, but not in a box with balls; then that of the highest maximum.
  Span<const PoreRegion> regions() const { return regions_.items(); }

 private:
  Status find_shells(const PoresBuilder &pores, const BallsAround &balls, const Boundary &boundary, int64_t floor,
                     Patience &patience);
  // False if they are stopped.
  bool measure_in_box(const PeriodicUnion &periodic, uint32_t first_plug, Patience &patience);
  bool measure(const BallSet &balls, const Boundary &boundary, uint32_t first_plug, Patience &patience);

  FixedVector<PoreRegion> regions_;
  Span<uint32_t> region_of_shell_;
  bool has_outside_ = false;
};

}  // namespace hsp
