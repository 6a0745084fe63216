// Paths of a point through free space. If the radius of a ball-shaped probe is part of the balls' radii, they are the
// paths of its centre.
//
// Regions decide exactly whether there is a path. The path itself is a polyline on the lattice: from cell to cell
// through portals, then shortened. It is certified if no segment meets a ball, which integers decide. A path through a
// passage narrower than a lattice step may remain without a certificate, by rounding.
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

// The places of both ends of a path.
enum class PathEnds : uint32_t {
  connected,  // in one region
  apart,      // in two regions
  covered,    // at least one of them is in a ball
};

struct PathSummary {
  PathEnds ends;
  bool certified;
  double length;     // in lattice steps
  double clearance;  // least distance from a ball, in lattice steps; infinite without balls
};

class PathFinder {
 public:
  void carve(Workspace &workspace, const PathLimits &limits);
  // As FreeSpaceBuilder::build().
  Status build(const CubeGrid &grid, Patience patience = Patience());
  // Status::capacity: needed_points() would have sufficed. Status::check would mean that cells disagree, and cannot
  // happen. Status::stopped if patience has ended.
  Status find(const BallSet &balls, const exact::Vector &from, const exact::Vector &to, PathSummary &summary,
              Patience patience = Patience());

  void forget_path() { points_.clear(); }

  // The points of the last path, from its start to its end; none if there is no path.
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
