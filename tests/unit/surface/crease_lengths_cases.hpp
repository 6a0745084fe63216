// Creases that are equally long in both of their patches, and those that are not.
#pragma once

#include "cusped_circles_cases.hpp"
#include "surface/crease_lengths.hpp"

namespace cases {

// The two probes of a throat share a whole circle; a crease between cusps has ends. The length of one of the two
// patches is spoilt by more than is allowed, and by less.
inline uint32_t lengths_of_creases() {
  uint32_t whole = 0;
  uint32_t with_ends = 0;
  const SurfaceScene *const scenes[] = {&three_throat, &three_almost, &void_in_tetrahedron, &cut_spindle};
  for (const SurfaceScene *scene : scenes) {
    if (!small_surface().build(*scene)) return 0;
    hsp::CutPatches cut = small_surface().builder().surface().cut_patches();
    const hsp::CreaseLengths lengths(small_union().balls(), small_union().boundary(), cut);
    const double largest = static_cast<double>(small_union().balls().largest_radius);
    for (uint32_t k = 0; k < cut.creases().size(); ++k) {
      const uint32_t a = cut.creases().member(k);
      hsp::PatchArc &arc = cut.arc(a);
      const hsp::PatchArc &twin = cut.arc(arc.twin);
      const bool is_whole = arc.next == a;
      (is_whole ? whole : with_ends) += 1;
      const double uncertainty = lengths.uncertainty(a);
      if (hsp::CreaseLengths::may_differ(arc, twin) || !lengths.agree(a)) return 1;
      if (is_whole ? uncertainty != 0.0 : !(uncertainty > 0.0 && uncertainty < 1e-6 * largest)) return 2;
      const double angle = arc.angle;
      arc.angle = angle + 1e-5;
      if (!hsp::CreaseLengths::may_differ(arc, twin) || !hsp::CreaseLengths::may_differ(twin, arc) ||
          lengths.agree(a) || lengths.agree(arc.twin)) {
        return 3;
      }
      arc.angle = angle - 1e-7;
      if (hsp::CreaseLengths::may_differ(arc, twin) || !lengths.agree(a)) return 4;
      arc.angle = angle;
    }
  }
  return whole > 0 && with_ends > 0 ? all_hold : 5;
}

// Two probes 2e-7 of their radius apart: what is between them and the others is known to a hundredth of it.
constexpr SurfaceScene nearly_tied = {5,
                                      {{99999991, 199999995, 5, 10000000},
                                       {200000006, 200000004, 7, 10000000},
                                       {199999994, 3, 1, 10000000},
                                       {199999991, -6, 99999999, 10000000},
                                       {99999996, -1, 100000010, 10000000}},
                                      200000000};
inline uint32_t uneven_creases_are_decided_once() {
  if (!small_surface().build(nearly_tied)) return 0;
  const hsp::Surface &surface = small_surface().builder().surface();
  if (!surface.is_of_actual_balls()) return 1;
  const hsp::CutPatches &cut = surface.cut_patches();
  const hsp::CreaseLengths lengths(small_union().balls(), small_union().boundary(), cut);
  for (uint32_t k = 0; k < cut.creases().size(); ++k) {
    if (!lengths.agree(cut.creases().member(k))) return 2;
  }
  return cut.creases().size() > 0 ? all_hold : 3;
}

inline constexpr Check surface_crease_lengths[] = {
    {"lengths_of_creases", lengths_of_creases}, {"uneven_creases_are_decided_once", uneven_creases_are_decided_once}};

}  // namespace cases
