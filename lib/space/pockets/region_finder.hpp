// Regions: the components of the space outside all balls, each with its maxima, the shells that bound it, its area and
// its volume. The balls may have been grown by a probe: then a region is a component of the places of its centre.
//
// Regions are the classes at level 0 of the tree in which classes merge; the boundary has their surface. A shell
// belongs to the region to which a way up from one of its points leads, if that is certain: the first step of the way
// leads away from all balls nearby, and more than three lattice steps above the boundary. From a point at which two
// regions touch no step does.
#pragma once

#include "boundary/boundary.hpp"
#include "pores/ascent.hpp"
#include "pores/pores_builder.hpp"

namespace hsp {

struct PoreRegion {
  uint32_t maximum;         // its highest maximum, or pore_outside
  uint32_t origin = no_id;  // a ball, in grid order, with a face on its surface
  uint32_t maxima = 0, shells = 0;
  double area = 0.0;
  double plug_area = 0.0;  // the part of the area that is on plugs
  double volume = 0.0;     // infinite for the outside without a box
  WindingLattice lattice{};
  // Set by claim().
  uint32_t owner = no_id;
  bool is_claimed = false;
  bool is_shared = false;
  // Whether the region goes on for ever.
  bool is_accessible() const { return maximum == pore_outside || lattice.rank > 0; }
};

class RegionFinder {
 public:
  void carve(Workspace &workspace, const PoreLimits &limits);
  // pores: built with a floor of 0 or less. periodic: null without a box. first_plug: from this number on the caller's
  // balls are plugs. pores.joined() becomes that of level 0. Status::range: no point of some shell certainly leads
  // anywhere, or as locate(). Status::check cannot happen. Status::stopped: patience has ended.
  Status find(PoresBuilder &pores, const BallsAround &balls, const Boundary &boundary, const PeriodicUnion *periodic,
              int64_t floor, uint32_t first_plug, Patience patience = Patience());
  // The region of a maximum of the same pores, or of the outside; no_id if it is in none. Valid while pores.joined()
  // has not changed.
  uint32_t region_of(const PoresBuilder &pores, uint32_t maximum) const {
    const uint32_t node = node_of(maximum);
    if (node >= pores.joined().size() || (node == 0 && !has_outside_)) return no_id;
    return pores.joined().component(node) - (has_outside_ ? 0 : 1);
  }
  // Notes that a region has something of an owner. It is shared if it has something of two.
  void claim(uint32_t region, uint32_t owner) {
    PoreRegion &claimed = regions_[region];
    if (!claimed.is_claimed) claimed.owner = owner;
    if (claimed.owner != owner) claimed.is_shared = true;
    claimed.is_claimed = true;
  }
  void forget() { regions_.clear(); }

  // The regions: first the outside, unless there is a box with balls; then in descending order of their highest maxima.
  Span<const PoreRegion> regions() const { return regions_.items(); }

 private:
  Status find_shells(const PoresBuilder &pores, const BallsAround &balls, const Boundary &boundary, int64_t floor,
                     Patience &patience);
  // Both return false if patience ends.
  bool measure_in_box(const PeriodicUnion &periodic, uint32_t first_plug, Patience &patience);
  bool measure(const BallSet &balls, const Boundary &boundary, uint32_t first_plug, Patience &patience);

  FixedVector<PoreRegion> regions_;
  Span<uint32_t> region_of_shell_;
  bool has_outside_ = false;
};

}  // namespace hsp
