#include "cells/side_facets.hpp"

namespace hsp {
namespace {

void widen(double value, double doubt, double &low, double &high) {
  low = value - doubt < low ? value - doubt : low;
  high = value + doubt > high ? value + doubt : high;
}

}  // namespace

void SideFacets::add(const PowerCell &cell, uint32_t side, uint32_t first_cell) {
  const PowerPolytope &polytope = cell.polytope();
  uint32_t first = 0;
  while (first < polytope.size() && (cell.part_of(first) == no_id || !polytope[first].has(side))) ++first;
  if (first == polytope.size()) return;
  SideFacet facet{cell.ball(), side, clamped_count(corners_.required()), 0, no_id, {}, {}};
  facet.low = facet.high = polytope[first].at.y;
  bool several = false;
  uint32_t v = first;
  // The edge that is followed next is on the side and on this plane of v.
  uint32_t line = polytope[v].plane[polytope[v].place_of(side) == 0 ? 1 : 0];
  do {
    const PolytopeVertex &vertex = polytope[v];
    const uint32_t opposite = 3 - vertex.place_of(side) - vertex.place_of(line);
    const uint32_t part = cell.part_of(v);
    const uint32_t in_cell = part == no_id ? no_id : first_cell + part;
    corners_.push({vertex.at, in_cell, cell.code_of(line), cell.is_free_edge(v, opposite) ? 1U : 0U});
    ++facet.corners;
    if (in_cell != no_id) {
      several |= facet.cell != no_id && facet.cell != in_cell;
      facet.cell = in_cell;
    }
    widen(vertex.at.y.x, vertex.at.doubt, facet.low.x, facet.high.x);
    widen(vertex.at.y.y, vertex.at.doubt, facet.low.y, facet.high.y);
    widen(vertex.at.y.z, vertex.at.doubt, facet.low.z, facet.high.z);
    v = vertex.neighbour[opposite];
    const PolytopeVertex &next = polytope[v];
    line = next.plane[3 - next.place_of(side) - next.place_of(line)];
  } while (v != first && facet.corners < polytope.size());
  if (several) facet.cell = no_id;
  facets_.push(facet);
}

}  // namespace hsp
