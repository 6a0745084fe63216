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
  double volume = 0.0;  // infinite of the outside without a box
  WindingLattice lattice{};
  // Whether it goes on for ever.
  bool is_accessible() const { return maximum == pore_outside || lattice.rank > 0; }
};

class RegionFinder {
 public:
  void carve(Workspace &workspace, const PoreLimits &limits);
  // pores: all above a floor of 0 or less. periodic: null without a box. pores.joined() becomes that of the level 0.
  // Status::range: of a shell no point is known to lead anywhere. Status::check cannot happen.
  Status find(PoresBuilder &pores, const BallsAround &balls, const Boundary &boundary, const PeriodicUnion *periodic,
              int64_t floor);
  void forget() { regions_.clear(); }

  // The outside first, but not in a box with balls; then that of the highest maximum.
  Span<const PoreRegion> regions() const { return regions_.items(); }

 private:
  Status find_shells(const PoresBuilder &pores, const BallsAround &balls, const Boundary &boundary, int64_t floor);
  void measure_in_box(const PeriodicUnion &periodic);
  void measure(const BallSet &balls, const Boundary &boundary);

  FixedVector<PoreRegion> regions_;
  Span<uint32_t> region_of_shell_;
  bool has_outside_ = false;
};

}  // namespace hsp
