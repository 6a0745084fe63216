#include "cells/facet_parts.hpp"

#include "cells/power_polytope.hpp"

namespace hsp {
namespace {

constexpr uint32_t parts_per_plane = 4, names_per_plane = 16;

}  // namespace

void FacetParts::carve(Workspace &workspace, uint64_t planes) {
  parts_ = FixedVector<Part>(workspace.take<Part>(parts_per_plane * planes));
  names_ = FixedVector<Name>(workspace.take<Name>(names_per_plane * planes));
}

uint32_t FacetParts::needed_balls() const {
  const auto balls_for = [](uint64_t required, uint64_t per_plane) {
    const uint64_t planes = (required + per_plane - 1) / per_plane;
    return clamped_count(planes > cube_sides ? planes - cube_sides : 0);
  };
  return larger_count(balls_for(parts_.required(), parts_per_plane), balls_for(names_.required(), names_per_plane));
}

bool FacetParts::touch(uint32_t a, uint32_t b) const {
  for (const uint32_t k : names_of(a)) {
    for (const uint32_t l : names_of(b)) {
      if (names_[k] == names_[l]) return true;
    }
  }
  return false;
}

// Whether no earlier part of the same two facets joins the same cells.
bool FacetParts::is_new(uint32_t part) const {
  const Part &own = parts_[part];
  for (uint32_t b = part; b-- > 0 && parts_[b].facet[0] == own.facet[0] && parts_[b].facet[1] == own.facet[1];) {
    if (parts_[b].cell[0] == own.cell[0] && parts_[b].cell[1] == own.cell[1]) return false;
  }
  return true;
}

Status FacetParts::resolve(const CubeFrame &frame, CellContacts &contacts) {
  const uint32_t count = parts_.size();
  bool unknown = false;
  for (bool progress = true; progress;) {
    progress = unknown = false;
    for (uint32_t a = 0; a < count; ++a) {
      for (uint32_t which = 0; which < 2; ++which) {
        if (parts_[a].cell[which] != no_id) continue;
        unknown = true;
        for (uint32_t b = 0; b < count; ++b) {
          if (parts_[b].facet[which] != parts_[a].facet[which] || parts_[b].cell[which] == no_id || !touch(a, b)) {
            continue;
          }
          parts_[a].cell[which] = parts_[b].cell[which];
          progress = true;
          break;
        }
      }
    }
  }
  if (unknown) return Status::check;
  for (uint32_t a = 0; a < count; ++a) {
    const Part &part = parts_[a];
    if (is_new(a)) contacts.push({{part.cell[0], part.cell[1]}}, frame, part.portal);
  }
  return Status::ok;
}

}  // namespace hsp
