#include "cells/cube_contacts.hpp"

namespace hsp {

void CubeContacts::carve(Workspace &workspace, uint32_t balls, uint32_t corners) {
  members_ = workspace.take<Member>(balls);
  corners_ = FixedVector<Corner>(workspace.take<Corner>(corners));
}

void CubeContacts::clear(uint32_t balls) {
  corners_.clear();
  for (uint32_t k = 0; k < balls; ++k) members_[k] = {0, 0, no_id, 0, no_id};
}

CubeContacts::Corner CubeContacts::sorted(uint32_t a, uint32_t b, uint32_t c, uint32_t cell) {
  const uint32_t least = a < b ? (a < c ? a : c) : (b < c ? b : c);
  const uint32_t most = a > b ? (a > c ? a : c) : (b > c ? b : c);
  return {{least, a ^ b ^ c ^ least ^ most, most}, cell};
}

uint32_t CubeContacts::cell_at(const Member &member, const Corner &corner) const {
  for (uint32_t k = member.first_corner; k < member.first_corner + member.corners; ++k) {
    const uint32_t *const plane = corners_[k].plane;
    if (plane[0] == corner.plane[0] && plane[1] == corner.plane[1] && plane[2] == corner.plane[2]) {
      return corners_[k].cell;
    }
  }
  return no_id;
}

Status CubeContacts::add(const PowerCell &cell, uint32_t k, uint32_t first_cell, CellContacts &contacts) {
  const PowerPolytope &polytope = cell.polytope();
  Member &own = members_[k];
  own = {clamped_count(corners_.required()), 0, first_cell, cell.parts(), no_id};
  for (uint32_t v = 0; v < polytope.size() && own.parts > 1; ++v) {
    if (cell.part_of(v) == no_id) continue;
    const uint32_t *const plane = polytope[v].plane;
    corners_.push(sorted(plane[0], plane[1], plane[2], first_cell + cell.part_of(v)));
    ++own.corners;
  }
  if (corners_.overflowed()) return Status::capacity;

  const uint64_t first_contact = contacts.required();
  const auto add_once = [&](const AdjacentCells &pair, const Vec3 &at) {
    const uint64_t stored = contacts.size();
    for (uint64_t c = first_contact; c < stored; ++c) {
      const AdjacentCells &known = contacts[static_cast<uint32_t>(c)];
      if (known.cell[0] == pair.cell[0] && known.cell[1] == pair.cell[1]) return;
    }
    contacts.push(pair, cell.frame(), at);
  };
  const uint32_t size = polytope.size();
  for (uint32_t v = 0; v < size; ++v) {
    if (cell.part_of(v) == no_id) continue;
    const uint32_t own_cell = first_cell + cell.part_of(v);
    for (uint32_t p = 0; p < 3; ++p) {
      const uint32_t plane = polytope[v].plane[p];
      if (plane < cube_sides || plane - cube_sides >= k) continue;
      Member &other = members_[plane - cube_sides];
      if (other.parts == 1 && own.parts == 1) {
        if (other.joined != k) contacts.push({{other.first_cell, own_cell}}, cell.frame(), polytope[v].at.y);
        other.joined = k;
        continue;
      }
      const uint32_t a = polytope[v].plane[p == 0 ? 1 : 0], b = polytope[v].plane[p == 2 ? 1 : 2];
      const uint32_t other_cell =
          other.parts == 1 ? other.first_cell : cell_at(other, sorted(a, b, cube_sides + k, no_id));
      if (other_cell == no_id) return Status::check;
      add_once({{other_cell, own_cell}}, polytope[v].at.y);
    }
  }
  return Status::ok;
}

}  // namespace hsp
