// Which free parts of the power cells of one cube are adjacent. A vertex of a facet that is outside both its balls (it
// has the same power to both) is a vertex of both power cells, with the same four balls or sides, and the parts that it
// belongs to are adjacent; every part of a facet without its balls has such a vertex. Vertices are only remembered of
// power cells with several parts.
#pragma once

#include "cells/free_space.hpp"
#include "cells/power_cell.hpp"

namespace hsp {

class CubeContacts {
 public:
  void carve(Workspace &workspace, uint32_t balls, uint32_t corners);
  // A new cube, with so many balls.
  void clear(uint32_t balls);
  // The power cell of member k of the cube, whose free parts are cells from first_cell on: finds those of members
  // before that are adjacent. Status::capacity: needed_corners() so far. Status::check cannot happen.
  Status add(const BallSet &balls, const PowerCell &cell, uint32_t k, uint32_t first_cell, CellContacts &contacts);
  uint64_t needed_corners() const { return corners_.required(); }

 private:
  struct Corner {
    uint32_t plane[3];  // numbers, ascending
    uint32_t cell;
  };
  struct Member {
    uint32_t first_corner, corners;
    uint32_t first_cell, parts;
  };
  static Corner sorted(uint32_t a, uint32_t b, uint32_t c, uint32_t cell);
  uint32_t cell_at(const Member &member, const Corner &corner) const;

  Span<Member> members_;
  Span<uint32_t> touched_;  // [members] those before one that have a free vertex with it
  FixedVector<Corner> corners_;
};

}  // namespace hsp
