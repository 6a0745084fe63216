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
  const Vec3 from = polytope.position(first);
  double low_u = from.*axes.u, high_u = low_u, low_w = from.*axes.w, high_w = low_w;
  double most_doubt = 0.0;
  bool several = false;
  uint32_t count = 0, covered = 0, the_cell = no_id;
  // Vertex v, to which the edge opposite to its plane number `back` leads: the border goes on along that plane.
  uint32_t v = first, back = previous_of_three(vertices[first].place_of(side));
  do {
    const PolytopeVertex &vertex = vertices[v];
    const uint32_t line = vertex.plane[back], opposite = previous_of_three(back);
    const PlacedPoint here = polytope.at(v);
    const double u = here.y.*axes.u, w = here.y.*axes.w, doubt = here.doubt;
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
    covered |= in_cell == no_id ? 1 : 0;
    if (in_cell != no_id) {
      several |= the_cell != no_id && the_cell != in_cell;
      the_cell = in_cell;
    }
    ++count;
    low_u = u < low_u ? u : low_u;
    high_u = u > high_u ? u : high_u;
    low_w = w < low_w ? w : low_w;
    high_w = w > high_w ? w : high_w;
    most_doubt = doubt > most_doubt ? doubt : most_doubt;
    v = vertex.neighbour(opposite);
    back = vertex.back(opposite);
  } while (v != first && count < most);
  corners_.set_count(first_corner + count);
  // As floats are off by less than 2^-23 of the side.
  const double spread = (most_doubt < 1e29 ? most_doubt : 1e29) + 0x1p-22 * cell.frame().side();
  facets_.push({cell.ball(), side, clamped_count(first_corner), count, several ? no_id : the_cell, most_doubt, covered,
                static_cast<float>(low_u - spread), static_cast<float>(high_u + spread),
                static_cast<float>(low_w - spread), static_cast<float>(high_w + spread)});
}

}  // namespace hsp
