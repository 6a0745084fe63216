#include "cells/side_facets.hpp"

namespace hsp {

void SideFacets::add(const PowerCell &cell, uint32_t side, uint32_t first, uint32_t first_cell) {
  const PowerPolytope &polytope = cell.polytope();
  const PolytopeVertex *const vertices = &polytope[0];
  SideFacet facet{cell.ball(), side, clamped_count(corners_.required()), 0, no_id, {}, {}};
  Vec3 low = vertices[first].at.y, high = low;
  double doubt = 0.0;
  const auto widen = [](double value, double &least, double &most) {
    least = value < least ? value : least;
    most = value > most ? value : most;
  };
  bool several = false;
  uint32_t corners = 0, the_cell = no_id;
  uint32_t v = first;
  // The edge that is followed next is on the side, plane `on` of v, and on plane `along`.
  uint32_t on = vertices[v].place_of(side), along = on == 0 ? 1 : 0;
  do {
    const PolytopeVertex &vertex = vertices[v];
    const uint32_t opposite = 3 - on - along, line = vertex.plane[along];
    const uint32_t part = cell.part_of(v);
    const uint32_t in_cell = part == no_id ? no_id : first_cell + part;
    corners_.push({vertex.at, in_cell, cell.code_of(line), cell.is_free_edge(v, opposite) ? 1U : 0U});
    ++corners;
    if (in_cell != no_id) {
      several |= the_cell != no_id && the_cell != in_cell;
      the_cell = in_cell;
    }
    widen(vertex.at.y.x, low.x, high.x);
    widen(vertex.at.y.y, low.y, high.y);
    widen(vertex.at.y.z, low.z, high.z);
    doubt = vertex.at.doubt > doubt ? vertex.at.doubt : doubt;
    v = vertex.neighbour[opposite];
    on = vertices[v].place_of(side);
    along = 3 - on - vertices[v].place_of(line);
  } while (v != first && corners < polytope.size());
  facet.corners = corners;
  facet.cell = several ? no_id : the_cell;
  facet.low = low - Vec3{doubt, doubt, doubt};
  facet.high = high + Vec3{doubt, doubt, doubt};
  facets_.push(facet);
}

}  // namespace hsp
