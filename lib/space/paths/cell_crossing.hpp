// A way between two points of one cell: straight, unless the cell's ball is in between; else along edges of the power
// cell.
//
// From a point x of a free part of the power cell K of a ball B, the plane through x that is normal to the way from the
// centre of B has a vertex of K beyond it, and the segment to that is outside B. It is in K, and so outside every ball.
// The vertices of the part are joined by its edges outside B (power_cell.hpp).
#pragma once

#include "cells/free_space.hpp"
#include "cells/power_cell.hpp"

namespace hsp {

class CellCrossing {
 public:
  void carve(Workspace &workspace, uint32_t cube_balls);
  // Adds the points between two points of a cell to a path. Ends of edges are rounded, so that segments are still to be
  // tested; none are added if rounding leaves no way.
  void add(const BallSet &balls, const FreeSpace &space, uint32_t cell, const exact::Vector &from,
           const exact::Vector &to, FixedVector<exact::Vector> &points);

 private:
  struct Stop {
    exact::Vector at;
    double way;
    uint32_t from;
    bool done;
  };

  PowerCell power_cell_;
  Span<Stop> stops_;
};

}  // namespace hsp
