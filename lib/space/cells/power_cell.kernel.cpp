// The kernels of power_cell, power_polytope and facet_overlay.
#include "cells/cube_members.hpp"
#include "cells/edge_crossings.hpp"
#include "cells/vertex_edges.hpp"
#include "cells/vertex_sides.hpp"

namespace hsp::HSP_TARGET {

uint32_t find_cut(const CutVertices &vertices, const PlaneArrays &planes, uint32_t plane_count,
                  const CutMargins &margins) {
  return find_cut_in_lanes<register_lanes>(vertices, planes, plane_count, margins);
}

SquareSides compare_squares(const double *squared, uint32_t count, double limit, double margin) {
  return compare_squares_in_lanes<register_lanes>(squared, count, limit, margin);
}

EdgeSides compare_edges(const VertexArrays &of, const EdgeEnds *edges, uint32_t count, double limit, double error) {
  return compare_edges_in_lanes<register_lanes>(of, edges, count, limit, error);
}

FacetSides compare_facets(const double *u, const double *w, uint32_t count, const FlatLine *lines, uint32_t line_count,
                          double margin) {
  return compare_facets_in_lanes<register_lanes>(u, w, count, lines, line_count, margin);
}

void cross_edges(const VertexArrays &of, const CrossedEdge *edges, const uint32_t *to, uint32_t count,
                 const CrossingBounds &bounds) {
  cross_edges_in_lanes<register_lanes>(of, edges, to, count, bounds);
}

void find_planes(const MemberArrays &members, const MemberBall &own, double limit, const PlaneArrays &planes) {
  find_planes_in_lanes<register_lanes>(members, own, limit, planes);
}

bool is_before_all(const MemberArrays &members, const MemberBall &own, const Vec3 &point, double error,
                   const double *distance) {
  return is_before_all_in_lanes<register_lanes>(members, own, point, error, distance);
}

uint64_t find_dominance(const MemberArrays &members, uint32_t a, uint32_t first, double side, double error) {
  return find_dominance_in_lanes<register_lanes>(members, a, first, side, error);
}

}  // namespace hsp::HSP_TARGET
