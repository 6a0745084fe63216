#include "cells/cube_contacts.hpp"

#include "core/sorting.hpp"

namespace hsp {

void CubeContacts::carve(Workspace &workspace, uint32_t balls, uint32_t corners) {
  members_ = workspace.take<Member>(balls);
  touched_ = workspace.take<uint32_t>(balls);
  corners_ = FixedVector<Corner>(workspace.take<Corner>(corners));
}

void CubeContacts::clear(uint32_t balls) {
  corners_.clear();
  for (uint32_t k = 0; k < balls; ++k) members_[k] = {0, 0, no_id, 0};
}

CubeContacts::Corner CubeContacts::sorted(uint32_t a, uint32_t b, uint32_t c, uint32_t cell) {
  sort_three(a, b, c);
  return {{a, b, c}, cell};
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

Status CubeContacts::add(const BallSet &balls, const PowerCell &cell, uint32_t k, uint32_t first_cell,
                         CellContacts &contacts) {
  const PowerPolytope &polytope = cell.polytope();
  Member &own = members_[k];
  own = {clamped_count(corners_.required()), 0, first_cell, cell.parts()};
  for (uint32_t v = 0; v < polytope.size() && own.parts > 1; ++v) {
    if (cell.part_of(v) == no_id) continue;
    const uint32_t *const plane = polytope[v].plane;
    corners_.push(sorted(plane[0], plane[1], plane[2], first_cell + cell.part_of(v)));
    ++own.corners;
  }
  if (corners_.overflowed()) return Status::capacity;

  // Of the corners that two parts have in common the portal is the one farthest from their balls. It has the same power
  // to both balls; the larger that is, the farther are both.
  const exact::Vector centre = balls.ball(cell.ball()).centre;
  const uint64_t first_contact = contacts.required();
  // Adds a pair. A known pair was added at an earlier corner, or only counted if there was no room.
  const auto add_once = [&](const AdjacentCells &pair, uint32_t v, bool is_known) {
    const Vec3 at = contacts.has_portals() ? cell.position(v) : Vec3{};
    const uint64_t stored = contacts.size();
    for (uint64_t c = first_contact; c < stored; ++c) {
      const uint32_t number = static_cast<uint32_t>(c);
      const AdjacentCells &known = contacts[number];
      if (known.cell[0] != pair.cell[0] || known.cell[1] != pair.cell[1]) continue;
      if (contacts.has_portals()) contacts.widen(number, cell.frame(), at, centre);
      return;
    }
    if (!is_known) contacts.push(pair, cell.frame(), at);
  };
  uint32_t *const touched = touched_.data();
  uint32_t count = 0;
  for (uint32_t c = 0; c < cell.cutters(); ++c) {
    const uint32_t member = cell.cutter(c);
    touched[count] = member;
    count += (member < k ? 1U : 0U) & (cell.first_free(cube_sides + member) != no_id ? 1U : 0U);
  }
  for (uint32_t c = 0; c < count; ++c) {
    const uint32_t plane = cube_sides + touched[c], first = cell.first_free(plane);
    const Member &other = members_[touched[c]];
    if (other.parts == 1 && own.parts == 1 && !contacts.has_portals()) {
      contacts.push({{other.first_cell, first_cell}});
      continue;
    }
    // Walks around the facet. A free edge joins vertices of the same two parts.
    uint32_t v = first, back = previous_of_three(polytope[first].slot_of(plane));
    AdjacentCells pair{};
    bool is_joined = false;
    do {
      const PolytopeVertex &vertex = polytope[v];
      const uint32_t on = previous_of_three(back);
      const bool is_free = cell.part_of(v) != no_id;
      if (is_free && !is_joined) {
        const uint32_t other_cell =
            other.parts == 1 ? other.first_cell
                             : cell_at(other, sorted(vertex.plane[back], vertex.plane[on], cube_sides + k, no_id));
        if (other_cell == no_id) return Status::check;
        pair = {{other_cell, first_cell + cell.part_of(v)}};
      }
      if (is_free && (!is_joined || contacts.has_portals())) add_once(pair, v, is_joined);
      is_joined = cell.is_free_edge(v, on);
      v = vertex.neighbour(on);
      back = vertex.back(on);
    } while (v != first);
  }
  return Status::ok;
}

}  // namespace hsp
