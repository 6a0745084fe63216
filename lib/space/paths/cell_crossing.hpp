// A way between two points of one cell: straight, unless the cell's ball is in between; else along edges of the power
// cell.
//
// From a point x of a free part of the power cell K of a ball B, the plane through x that is normal to the way from the
// centre of B has a vertex of K beyond it, and the segment to that is outside B. It is in K, and so outside every ball.
// The vertices of the part are joined by its edges outside B (power_cell.hpp).
//
// Rounded to the lattice such a segment may leave K by a step, where its power to another ball is less than that to B
// by as little. If B is large, that is no depth at all in B, and all of the other ball if that is small. So segments
// come first that are outside all balls of the cube. Rounded x may be in B, too, or the segment to each vertex may
// touch it. Then that vertex of the part is taken of which the segment is farthest from B, or least deep in it: by the
// rounding, and not by more.
#pragma once

#include "cells/free_space.hpp"
#include "cells/power_cell.hpp"

namespace hsp {

class CellCrossing {
 public:
  void carve(Workspace &workspace, uint32_t cube_balls);
  // Adds the points between two points of a cell to a path. Ends of edges are rounded, so that segments are still to be
  // tested.
  void add(const BallSet &balls, const FreeSpace &space, uint32_t cell, const exact::Vector &from,
           const exact::Vector &to, FixedVector<exact::Vector> &points);

 private:
  struct Stop {
    exact::Vector at;
    double way;     // from here to the end
    uint32_t next;  // on it
    bool done;
  };

  // The first and the last segment of a way have to be outside all balls of the cube, or outside the cell's ball, or
  // nothing but least deep in that.
  enum class Ends { outside_all, outside_ball, least_deep };

  // The part of the power cell that a cell is. Parts come in the order of vertices, and that depends on the planes that
  // cut on the way: where the cells were found these were fewer, as balls without a power cell were left out.
  uint32_t part_of_cell(const FreeSpace &space, uint32_t cell) const;
  // The shortest way along edges, from its first vertex on, each with the next one; no_id if there is none. Between any
  // vertices with segments as are asked for, or between those of that part that suit best. members: of the cube.
  uint32_t first_stop(const BallSet &balls, Span<const uint32_t> members, uint32_t part, Ends ends,
                      const exact::Vector &from, const exact::Vector &to);

  PowerCell power_cell_;
  Span<Stop> stops_;
};

}  // namespace hsp
