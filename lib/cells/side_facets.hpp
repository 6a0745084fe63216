// The facets that power cells have on a side of their cube, as polygons: what is compared with those of the cube on the
// other side.
#pragma once

#include "cells/power_cell.hpp"
#include "core/fixed_vector.hpp"

namespace hsp {

// A corner of a facet, and the edge from it to the next one.
struct FacetCorner {
  PlacedPoint at;
  uint32_t cell;       // no_id for a corner inside the ball
  uint32_t line;       // the code of the other plane of the edge
  uint32_t edge_free;  // whether the edge is outside the ball as a whole
};

struct SideFacet {
  uint32_t ball;
  uint32_t side;
  uint32_t first_corner, corners;
  uint32_t cell;   // the cell of all corners outside the ball; no_id if there are several
  Vec3 low, high;  // a box around the facet, along the side
};

class SideFacets {
 public:
  void carve(Workspace &workspace, uint32_t facets, uint32_t corners) {
    facets_ = FixedVector<SideFacet>(workspace.take<SideFacet>(facets));
    corners_ = FixedVector<FacetCorner>(workspace.take<FacetCorner>(corners));
  }
  void clear() {
    facets_.clear();
    corners_.clear();
  }
  // The facet of a power cell on a side, where `first` is a vertex of the cell outside the ball; first_cell is that of
  // the cell's free part 0.
  void add(const PowerCell &cell, uint32_t side, uint32_t first, uint32_t first_cell);

  const FixedVector<SideFacet> &facets() const { return facets_; }
  const FixedVector<FacetCorner> &corners() const { return corners_; }
  const SideFacet &facet(uint32_t k) const { return facets_[k]; }
  const FacetCorner &corner(const SideFacet &facet, uint32_t k) const { return corners_[facet.first_corner + k]; }
  bool overflowed() const { return facets_.overflowed() || corners_.overflowed(); }

 private:
  FixedVector<SideFacet> facets_;
  FixedVector<FacetCorner> corners_;
};

}  // namespace hsp
