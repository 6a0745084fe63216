// A way between two points of one cell: straight, unless the cell's ball is in between; then along edges of the power
// cell.
//
// Let x be a point of a free part of the power cell K of a ball B. The plane through x that is normal to the way from
// the centre of B to x has a vertex of K on its far side, and the segment from x to that vertex is outside B. The
// segment is in K, and so outside every ball. The vertices of the part are joined by its edges outside B
// (power_cell.hpp).
//
// Rounded to the lattice such a segment may leave K by a step. There its power to another ball is a little less than
// that to B. If B is large, that is no depth to speak of in B, but it may be all of a small other ball. So segments
// outside all balls of the cube are tried first. The rounded x may also be in B, or the segment to each vertex may
// touch B. Then the vertex is taken whose segment is farthest from B, or least deep in it: by the rounding, and not by
// more.
#pragma once

#include "cells/free_space.hpp"
#include "cells/power_cell.hpp"

namespace hsp {

class CellCrossing {
 public:
  void carve(Workspace &workspace, uint32_t cube_balls);
  // Appends to a path the points of a way between two points of a cell. Ends of edges are rounded, so that the segments
  // still have to be tested.
  void add(const BallSet &balls, const FreeSpace &space, uint32_t cell, const exact::Vector &from,
           const exact::Vector &to, FixedVector<exact::Vector> &points);

 private:
  struct Stop {
    exact::Vector at;
    double way;     // length of the way from here to the end
    uint32_t next;  // the next stop of that way
    bool done;
  };

  // The condition for the first and the last segment of a way: outside all balls of the cube; outside the cell's ball;
  // or only as little deep in the cell's ball as possible.
  enum class Ends { outside_all, outside_ball, least_deep };

  // The number of the free part of the power cell that is the given cell. Parts are numbered in the order of vertices,
  // which depends on the planes that have cut the cell. The builder has cut with fewer planes, without balls whose
  // power cells are empty: so the numbers may differ.
  uint32_t part_of_cell(const FreeSpace &space, uint32_t cell) const;
  // Finds the shortest way along edges; returns its first vertex, and sets `next` of each; no_id if there is none. It
  // goes between any vertices whose segments fulfil the condition, or between the vertices of the part whose segments
  // are least deep. members: the balls of the cube.
  uint32_t first_stop(const BallSet &balls, Span<const uint32_t> members, uint32_t part, Ends ends,
                      const exact::Vector &from, const exact::Vector &to);

  PowerCell power_cell_;
  Span<Stop> stops_;
};

}  // namespace hsp
