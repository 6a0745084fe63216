#include "cells/side_facets.hpp"

namespace hsp {

void SideFacets::add(const PowerCell &cell, uint32_t side, uint32_t first, uint32_t first_cell) {
  const PowerPolytope &polytope = cell.polytope();
  const PolytopeVertex *const vertices = &polytope[0];
  const SideAxes axes = axes_along(side / 2);
  const double there = side % 2 == 0 ? -cell.frame().side() : cell.frame().side();
  const uint32_t most = polytope.size();
  const uint64_t first_corner = corners_.required();
  // Corners that there is no room for are counted all the same.
  const uint32_t at = first_corner < corners_.capacity() ? static_cast<uint32_t>(first_corner) : corners_.capacity();
  const uint32_t room = corners_.capacity() - at;
  FacetCorner *const corners = corners_.room().data() + at;
  FlatLine *const lines = lines_.data() + at;
  double *const us = u_.data() + at, *const ws = w_.data() + at;
  double low_u = vertices[first].at.y.*axes.u, high_u = low_u, low_w = vertices[first].at.y.*axes.w, high_w = low_w;
  double most_doubt = 0.0;
  uint64_t free_corners = 0;
  bool several = false;
  uint32_t count = 0, the_cell = no_id;
  uint32_t v = first;
  // The edge that is followed next is on the side, plane `on` of v, and on plane `along`.
  uint32_t on = vertices[v].place_of(side), along = on == 0 ? 1 : 0;
  do {
    const PolytopeVertex &vertex = vertices[v];
    const uint32_t opposite = 3 - on - along, line = vertex.plane[along];
    const double u = vertex.at.y.*axes.u, w = vertex.at.y.*axes.w, doubt = vertex.at.doubt;
    const uint32_t part = cell.part_of(v);
    const uint32_t in_cell = part == no_id ? no_id : first_cell + part;
    if (count < room) {
      const UnitPlane &plane = cell.unit_plane(line);
      us[count] = u;
      ws[count] = w;
      lines[count] = {static_cast<float>(plane.v.*axes.u), static_cast<float>(plane.v.*axes.w),
                      static_cast<float>(plane.h - plane.v.*axes.across * there)};
      // Rounded up.
      const float rounded = doubt < 1e29 ? static_cast<float>(doubt * (1.0 + 0x1p-20)) : huge_doubt;
      corners[count] = {rounded, in_cell, cell.code_of(line), cell.is_free_edge(v, opposite) ? 1U : 0U};
    }
    if (in_cell != no_id) {
      several |= the_cell != no_id && the_cell != in_cell;
      the_cell = in_cell;
      free_corners |= count < 64 ? UINT64_C(1) << count : 0;
    }
    ++count;
    low_u = u < low_u ? u : low_u;
    high_u = u > high_u ? u : high_u;
    low_w = w < low_w ? w : low_w;
    high_w = w > high_w ? w : high_w;
    most_doubt = doubt > most_doubt ? doubt : most_doubt;
    v = vertex.neighbour[opposite];
    on = vertices[v].place_of(side);
    along = 3 - on - vertices[v].place_of(line);
  } while (v != first && count < most);
  corners_.set_count(first_corner + count);
  // As floats are off by less than 2^-23 of the side.
  const double spread = (most_doubt < 1e29 ? most_doubt : 1e29) + 0x1p-22 * cell.frame().side();
  facets_.push({cell.ball(), side, clamped_count(first_corner), count, several ? no_id : the_cell, most_doubt,
                free_corners, static_cast<float>(low_u - spread), static_cast<float>(high_u + spread),
                static_cast<float>(low_w - spread), static_cast<float>(high_w + spread)});
}

}  // namespace hsp
