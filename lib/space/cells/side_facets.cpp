#include "cells/side_facets.hpp"

namespace hsp {
namespace {

// Tables by the axis that a side is normal to, so that no branch depends on it.
constexpr SideAxes axes_of[3] = {axes_along(0), axes_along(1), axes_along(2)};
constexpr double *VertexArrays::*numbers_along_u[3] = {&VertexArrays::y, &VertexArrays::x, &VertexArrays::x};
constexpr double *VertexArrays::*numbers_along_w[3] = {&VertexArrays::z, &VertexArrays::z, &VertexArrays::y};

}  // namespace

void SideFacets::add(const PowerCell &cell, uint32_t side, uint32_t first, uint32_t first_cell, bool meets_both) {
  const PowerPolytope &polytope = cell.polytope();
  const PolytopeVertex *const vertices = &polytope[0];
  const VertexArrays arrays = polytope.arrays();
  const UnitPlane *const planes = &cell.unit_plane(0);
  const SideAxes axes = axes_of[side / 2];
  const double *const all_u = arrays.*numbers_along_u[side / 2], *const all_w = arrays.*numbers_along_w[side / 2];
  const double there = (2.0 * (side % 2) - 1.0) * cell.frame().side();
  const uint32_t most = polytope.size();
  const uint64_t first_corner = corners_.required();
  // Corners that there is no room for are counted all the same.
  const uint32_t at = first_corner < corners_.capacity() ? static_cast<uint32_t>(first_corner) : corners_.capacity();
  const uint32_t room = corners_.capacity() - at;
  FacetCorner *const corners = corners_.room().data() + at;
  FlatLine *const lines = lines_.data() + at;
  double *const us = u_.data() + at, *const ws = w_.data() + at;
  double low_u = all_u[first], high_u = low_u, low_w = all_w[first], high_w = low_w;
  double most_error = 0.0;
  // The lowest cell of a corner, and the highest one plus 1. no_id, the largest number, changes neither.
  uint32_t lowest = no_id, above_highest = 0;
  uint32_t count = 0, covered = 0;
  // The walk is at vertex v, which it has reached along the edge opposite to plane[back]. The next edge of the border
  // is on that plane.
  uint32_t v = first, back = previous_of_three(vertices[first].slot_of(side));
  do {
    const PolytopeVertex &vertex = vertices[v];
    const uint32_t line = vertex.plane[back], opposite = previous_of_three(back);
    const double u = all_u[v], w = all_w[v], error = arrays.error[v];
    const uint32_t part = cell.part_of(v), in_ball = part == no_id ? 1 : 0;
    const uint32_t in_cell = (first_cell + part) | (0 - in_ball);  // no_id has all bits
    if (count < room) {
      const UnitPlane &plane = planes[line];
      us[count] = u;
      ws[count] = w;
      lines[count] = {static_cast<float>(plane.v.*axes.u), static_cast<float>(plane.v.*axes.w),
                      static_cast<float>(plane.h - plane.v.*axes.across * there)};
      // The error is rounded up.
      const float rounded = error < 1e29 ? static_cast<float>(error * (1.0 + 0x1p-20)) : huge_error;
      corners[count] = {rounded, in_cell, cell.code_of(line), cell.is_free_edge(v, opposite) ? 1U : 0U};
    }
    ++count;
    covered |= in_ball;
    lowest = in_cell < lowest ? in_cell : lowest;
    above_highest = in_cell + 1 > above_highest ? in_cell + 1 : above_highest;
    low_u = u < low_u ? u : low_u;
    high_u = u > high_u ? u : high_u;
    low_w = w < low_w ? w : low_w;
    high_w = w > high_w ? w : high_w;
    most_error = error > most_error ? error : most_error;
    v = vertex.link[opposite] / 4;
    back = vertex.link[opposite] % 4;
  } while (v != first && count < most);
  const uint32_t written = count < room ? count : room;
  for (uint32_t k = written; k < written + read_behind; ++k) us[k] = ws[k] = 0.0;
  corners_.set_count(first_corner + count);
  // The box is widened: its floats are off by less than 2^-23 of the side.
  const double spread = (most_error < 1e29 ? most_error : 1e29) + 0x1p-22 * cell.frame().side();
  facets_.push({cell.ball(), side, clamped_count(first_corner), count, lowest + 1 == above_highest ? lowest : no_id,
                meets_both ? 1U : 0U, most_error, covered, static_cast<float>(low_u - spread),
                static_cast<float>(high_u + spread), static_cast<float>(low_w - spread),
                static_cast<float>(high_w + spread)});
}

}  // namespace hsp
