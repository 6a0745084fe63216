#if HSP_AVX2
#include "cells/cube_members.hpp"
#include "cells/edge_crossings.hpp"
#include "cells/vertex_edges.hpp"
#include "cells/vertex_sides.hpp"

namespace hsp {

uint32_t find_cut_avx2(const CutVertices &vertices, const PlaneArrays &planes, uint32_t plane_count,
                       const CutMargins &margins) {
  return find_cut<4>(vertices, planes, plane_count, margins);
}

SquareSides compare_squares_avx2(const double *squared, uint32_t count, double limit, double margin) {
  return compare_squares<4>(squared, count, limit, margin);
}

EdgeSides compare_edges_avx2(const VertexArrays &of, const EdgeEnds *edges, uint32_t count, double limit,
                             double doubt) {
  return compare_edges<4>(of, edges, count, limit, doubt);
}

FacetSides compare_facets_avx2(const double *u, const double *w, uint32_t count, const FlatLine *lines,
                               uint32_t line_count, double margin) {
  return compare_facets<4>(u, w, count, lines, line_count, margin);
}

void cross_edges_avx2(const VertexArrays &of, const CrossedEdge *edges, const uint32_t *to, uint32_t count,
                      const CrossingBounds &bounds) {
  cross_edges<4>(of, edges, to, count, bounds);
}

void find_planes_avx2(const MemberArrays &members, uint32_t own, double limit, const PlaneArrays &planes) {
  find_planes<4>(members, own, limit, planes);
}

bool is_before_all_avx2(const MemberArrays &members, uint32_t own, const Vec3 &point, double doubt,
                        const double *distance) {
  return is_before_all<4>(members, own, point, doubt, distance);
}

uint64_t find_dominance_avx2(const MemberArrays &members, uint32_t a, uint32_t first, double side, double doubt) {
  return find_dominance<4>(members, a, first, side, doubt);
}

}  // namespace hsp
#endif
