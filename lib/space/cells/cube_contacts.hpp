// Finds which free parts of the power cells of one cube are adjacent. A facet has the same power to its two balls. So a
// vertex of it that is outside one ball is outside both; it is a vertex of both power cells, with the same four balls
// or sides, and the two parts that it belongs to are adjacent. Every free part of a facet has such a vertex. Only of
// power cells with several parts vertices are remembered.
#pragma once

#include "cells/free_space.hpp"
#include "cells/power_cell.hpp"

namespace hsp {

class CubeContacts {
 public:
  void carve(Workspace &workspace, uint32_t balls, uint32_t corners);
  // Begins a cube with so many balls.
  void clear(uint32_t balls);
  // Takes the power cell of member k of the cube, whose free parts are the cells from first_cell on. Adds the contacts
  // with cells of members before. Status::capacity: so far needed_corners() is needed. Status::check cannot happen.
  Status add(const BallSet &balls, const PowerCell &cell, uint32_t k, uint32_t first_cell, CellContacts &contacts);
  uint64_t needed_corners() const { return corners_.required(); }

 private:
  struct Corner {
    uint32_t plane[3];  // plane numbers, ascending
    uint32_t cell;
  };
  struct Member {
    uint32_t first_corner, corners;
    uint32_t first_cell, parts;
  };
  static Corner sorted(uint32_t a, uint32_t b, uint32_t c, uint32_t cell);
  uint32_t cell_at(const Member &member, const Corner &corner) const;

  Span<Member> members_;
  Span<uint32_t> touched_;  // [members] the members before that share a free vertex with the new one
  FixedVector<Corner> corners_;
};

}  // namespace hsp
