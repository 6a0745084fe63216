// The facets of power cells on a side of their cube, as polygons, to be compared with the facets of the cube on the
// other side. Positions on a side are (u, w), the coordinates along it, the axis with the lower number first.
//
// The lines around a facet are kept in floats. v is a unit vector; |h| is < 4 s, and < 5 s after the term across the
// side is subtracted. So a u + b w - h is off by less than 2^-24 (2 s + 5 s) + 512 u s < 2^-21 s at a point that is
// known exactly.
#pragma once

#include "cells/power_cell.hpp"
#include "core/fixed_vector.hpp"

namespace hsp {

// The two coordinates along a side that is normal to an axis, and the one across it.
struct SideAxes {
  double Vec3::*u, Vec3::*w, Vec3::*across;
};
constexpr SideAxes axes_along(uint32_t axis) {
  return {axis == 0 ? &Vec3::y : &Vec3::x, axis == 2 ? &Vec3::y : &Vec3::z,
          axis == 0   ? &Vec3::x
          : axis == 1 ? &Vec3::y
                      : &Vec3::z};
}

// A corner of a facet, and the edge from it to the next one.
struct FacetCorner {
  float error;         // huge_error or more if the position is not known
  uint32_t cell;       // no_id for a corner inside the ball
  uint32_t line;       // the code of the other plane of the edge
  uint32_t edge_free;  // whether the edge is outside the ball as a whole
};
inline constexpr float huge_error = 1e30F;

struct SideFacet {
  uint32_t ball;
  uint32_t side;
  uint32_t first_corner, corners;
  uint32_t cell;                       // the cell of all corners outside the ball; no_id if there are several
  uint32_t meets_both;                 // whether its ball meets the cube on the other side too, 1 or 0
  double error;                        // the largest error of its corners
  uint32_t has_covered_corner;         // whether a corner is in the ball, 1 or 0
  float low_u, high_u, low_w, high_w;  // a box around the facet
};

class SideFacets {
 public:
  void carve(Workspace &workspace, uint32_t facets, uint32_t corners) {
    facets_ = FixedVector<SideFacet>(workspace.take<SideFacet>(facets));
    corners_ = FixedVector<FacetCorner>(workspace.take<FacetCorner>(corners));
    lines_ = workspace.take<FlatLine>(corners);
    workspace.take_each(static_cast<uint64_t>(corners) + read_behind, u_, w_);
  }
  void clear() {
    facets_.clear();
    corners_.clear();
  }
  // Adds the facet of a power cell on a side. first: a vertex of the facet outside the ball; first_cell: the cell that
  // is free part 0; meets_both: whether the ball meets the cube on the other side too.
  void add(const PowerCell &cell, uint32_t side, uint32_t first, uint32_t first_cell, bool meets_both);

  const FixedVector<SideFacet> &facets() const { return facets_; }
  const FixedVector<FacetCorner> &corners() const { return corners_; }
  const SideFacet &facet(uint32_t k) const { return facets_[k]; }
  const FacetCorner &corner(const SideFacet &facet, uint32_t k) const { return corners_[facet.first_corner + k]; }
  // The position of a corner. there: the coordinate of the side along its axis.
  BoundedPoint point(const SideFacet &facet, uint32_t k, const SideAxes &axes, double there) const {
    const uint32_t corner = facet.first_corner + k;
    BoundedPoint at;
    at.y.*axes.u = u_[corner];
    at.y.*axes.w = w_[corner];
    at.y.*axes.across = there;
    at.error = corners_[corner].error < huge_error ? static_cast<double>(corners_[corner].error) : no_certainty;
    return at;
  }
  // The coordinates of a facet's corners, readable for three more behind the last one; and the lines of its edges.
  const double *u(const SideFacet &facet) const { return u_.data() + facet.first_corner; }
  const double *w(const SideFacet &facet) const { return w_.data() + facet.first_corner; }
  const FlatLine *lines(const SideFacet &facet) const { return lines_.data() + facet.first_corner; }
  bool overflowed() const { return facets_.overflowed() || corners_.overflowed(); }

 private:
  static constexpr uint32_t read_behind = 3;

  FixedVector<SideFacet> facets_;
  FixedVector<FacetCorner> corners_;
  Span<FlatLine> lines_;  // [corners]
  Span<double> u_, w_;    // [corners + read_behind]
};

}  // namespace hsp
