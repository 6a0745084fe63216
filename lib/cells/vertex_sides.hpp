// On which side of a plane, or of the lines around a facet, up to 64 points lie, as far as doubles tell. For registers
// of n doubles: power_polytope.cpp, facet_overlay.cpp and wide_cells_avx2.cpp compile it, and all find the same bits.
#pragma once

#include "core/double_lanes.hpp"

namespace hsp {

// Coordinates and what v.y - h is found to be; behind the last point there is room for a multiple of four.
struct PointValues {
  const double *x, *y, *z;
  double *value;
};
struct PlaneNumbers {
  double x, y, z, h;
};
// A bit for each point, the first one lowest: v.y - h is larger than a margin; or it is not, but above minus that.
struct VertexSides {
  uint64_t beyond, unsure;
};

// A line in the plane of a facet, u a + w b = h; the near side has less. In floats, as facets are many.
struct FlatLine {
  float u, w, h;
};
// Of points in that plane those that are on the near side of all lines, by more than a margin; whether all of them are
// beyond one line, by more than that.
struct FacetSides {
  uint64_t inside;
  bool apart;
};

#if HSP_AVX2
VertexSides find_sides_avx2(const PointValues &points, uint32_t count, const PlaneNumbers &plane, double margin);
FacetSides compare_facets_avx2(const double *u, const double *w, uint32_t count, const FlatLine *lines,
                               uint32_t line_count, double margin);
#endif

namespace {

template <uint32_t n>
inline VertexSides find_sides(const PointValues &points, uint32_t count, const PlaneNumbers &plane, double margin) {
  using L = DoubleLanes<n>;
  using Real = typename L::Real;
  const Real a = L::all(plane.x), b = L::all(plane.y), c = L::all(plane.z), h = L::all(plane.h);
  const Real least = L::all(-margin);
  typename L::Mask any{};
  for (uint32_t k = 0; k < count; k += n) {
    const Real value = a * L::load(points.x + k) + b * L::load(points.y + k) + c * L::load(points.z + k) - h;
    any |= value > least;
    L::store(points.value + k, value);
  }
  if (!L::any(any)) return {0, 0};  // most planes are too far away
  const Real most = L::all(margin);
  uint64_t beyond = 0, near = 0;
  for (uint32_t k = 0; k < count; k += n) {
    const Real value = L::load(points.value + k);
    beyond |= L::set_lanes(value > most) << k;
    near |= L::set_lanes(value <= least) << k;
  }
  const uint64_t all = ~UINT64_C(0) >> (64 - count);
  return {beyond & all, ~(beyond | near) & all};
}

template <uint32_t n>
inline FacetSides compare_facets(const double *u, const double *w, uint32_t count, const FlatLine *lines,
                                 uint32_t line_count, double margin) {
  using L = DoubleLanes<n>;
  using Real = typename L::Real;
  const uint64_t all = ~UINT64_C(0) >> (64 - count);
  const Real most = L::all(margin), least = L::all(-margin);
  uint64_t inside = all;
  for (uint32_t line = 0; line < line_count; ++line) {
    const Real a = L::all(lines[line].u), b = L::all(lines[line].w), h = L::all(lines[line].h);
    uint64_t beyond = 0, near = 0;
    for (uint32_t k = 0; k < count; k += n) {
      const Real value = a * L::load(u + k) + b * L::load(w + k) - h;
      beyond |= L::set_lanes(value > most) << k;
      near |= L::set_lanes(value < least) << k;
    }
    if ((~beyond & all) == 0) return {0, true};
    inside &= near;
  }
  return {inside, false};
}

}  // namespace
}  // namespace hsp
