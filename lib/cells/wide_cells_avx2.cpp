#if HSP_AVX2
#include "cells/cube_members.hpp"
#include "cells/vertex_sides.hpp"

namespace hsp {

VertexSides find_sides_avx2(const PointValues &points, uint32_t count, const PlaneNumbers &plane, double margin) {
  return find_sides<4>(points, count, plane, margin);
}

FacetSides compare_facets_avx2(const double *u, const double *w, uint32_t count, const FlatLine *lines,
                               uint32_t line_count, double margin) {
  return compare_facets<4>(u, w, count, lines, line_count, margin);
}

uint32_t list_candidates_avx2(const MemberArrays &members, const uint64_t *in_game, uint32_t own, double limit,
                              PlaneCandidate *candidates) {
  return list_candidates<4>(members, in_game, own, limit, candidates);
}

uint64_t find_dominance_avx2(const MemberArrays &members, uint32_t a, uint32_t first, double side, double doubt) {
  return find_dominance<4>(members, a, first, side, doubt);
}

}  // namespace hsp
#endif
