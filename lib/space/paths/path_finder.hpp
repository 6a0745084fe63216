// Paths for a point through free space: for a ball-shaped probe that is a part of the radii, those of its centre.
//
// Whether there is one is decided by regions, exactly. The path itself is a polyline on the lattice: cells from portal
// to portal, shortened. It is certified if no segment meets a ball, which integers decide. A rounding by a lattice
// step can leave a passage that is narrower than this without a certificate.
#pragma once

#include "cells/free_space_builder.hpp"
#include "paths/cell_crossing.hpp"
#include "paths/cell_search.hpp"

namespace hsp {

struct PathLimits {
  FreeSpaceLimits cells;
  uint32_t points = 0;  // of a path before it is shortened
};

// Limits that suffice for most molecules. Status::range if one would be larger than max_count.
constexpr Status default_limits(uint32_t balls, PathLimits &limits) {
  const Status status = default_limits(balls, limits.cells);
  if (status == Status::ok) limits.points = 4 * balls + 1024;
  return status;
}

// Where a path may lead.
enum class PathEnds : uint32_t {
  connected,
  apart,    // in two regions
  covered,  // at least one of them is in a ball
};

struct PathSummary {
  PathEnds ends;
  bool certified;
  double length;     // in lattice steps
  double clearance;  // likewise; infinite without balls
};

class PathFinder {
 public:
  void carve(Workspace &workspace, const PathLimits &limits);
  // As FreeSpaceBuilder::build.
  Status build(const CubeGrid &grid, Patience patience = Patience());
  // Status::capacity: needed_points() would have sufficed. Status::check would mean that cells disagree, and cannot
  // happen. Status::stopped if more is not allowed.
  Status find(const BallSet &balls, const exact::Vector &from, const exact::Vector &to, PathSummary &summary,
              Patience patience = Patience());

  void forget_path() { points_.clear(); }

  // Of the last path, from its start to its end; none if there is no path.
  Span<const exact::Vector> points() const { return points_.items(); }
  uint32_t needed_points() const { return needed_points_; }
  // The limits that suffice for the cells and for the last path.
  PathLimits needed() const { return {builder_.needed(), needed_points_}; }
  // The limits to try again with after Status::capacity.
  PathLimits retry_limits() const {
    return {builder_.retry_limits(), larger_count(points_.capacity(), needed_points_)};
  }
  const FreeSpaceBuilder &cells() const { return builder_; }

 private:
  Status stop();
  void shorten(const BallSet &balls, Patience &patience);

  FreeSpaceBuilder builder_;
  CellSearch search_;
  CellCrossing crossing_;
  FixedVector<exact::Vector> points_;
  uint32_t needed_points_ = 0;
};

}  // namespace hsp
