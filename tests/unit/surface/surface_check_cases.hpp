// The self-check holds for sound surfaces and names what is wrong with others.
#pragma once

#include "surface/surface_check.hpp"
#include "surface_shells_cases.hpp"

namespace cases {

inline hsp::SurfaceInvariant checked() {
  return hsp::check_surface(small_map()).invariant;
}

inline uint32_t sound_surfaces() {
  for (const MapCase &c : map_cases) {
    if (!small_surface().build(*c.scene) || checked() != hsp::SurfaceInvariant::none) {
      return static_cast<uint32_t>(&c - map_cases);
    }
  }
  for (uint32_t seed = 0; seed < 200; ++seed) {
    if (!small_surface().build(random_scene(seed)) || checked() != hsp::SurfaceInvariant::none) return 100 + seed;
  }
  return all_hold;
}

// Probes on both sides of the plane of these balls touch each other in it: where the balls grow they part, so there is
// no hole.
constexpr SurfaceScene probes_in_touch = {4,
                                          {{-300000000, -200000000, 0, 100000000},
                                           {300000000, -200000000, 0, 100000000},
                                           {200000000, -300000000, 0, 100000000},
                                           {200000000, 300000000, 0, 100000000}},
                                          600000000};

struct EulerCase {
  const SurfaceScene *scene;
  int32_t euler;
};
constexpr EulerCase euler_cases[] = {{&three_throat, 0},   {&three_almost, 0},         {&three_open, 6},
                                     {&spindle, 4},        {&void_in_tetrahedron, -4}, {&cut_spindle, 2},
                                     {&probes_in_touch, 2}};

inline uint32_t euler_numbers() {
  return first_failing(euler_cases, [](const EulerCase &c) {
    if (!small_surface().build(*c.scene)) return false;
    int32_t euler = 0;
    hsp::count_euler(small_map(), [&euler](uint32_t, int32_t n) { euler += n; });
    return euler == c.euler;
  });
}

// Records that are spoilt behind the builder's back.
inline uint32_t mistakes_are_named() {
  if (!small_surface().build(three_throat)) return 0;
  hsp::CutPatches cut = small_surface().builder().surface().cut_patches();
  uint32_t crease = 0;
  while (cut.arc(crease).is_side()) ++crease;
  cut.arc(crease).angle *= 0.99;
  if (checked() != hsp::SurfaceInvariant::creases) return 1;
  cut.arc(cut.arc(crease).twin).angle *= 0.99;
  if (checked() != hsp::SurfaceInvariant::closure) return 2;
  if (!small_surface().build(cut_spindle)) return 3;
  cut = small_surface().builder().surface().cut_patches();
  for (uint32_t a = 0; a < cut.arc_count(); ++a) {
    if (cut.arc(a).is_side()) continue;
    const uint32_t own = cut.arc(a).corner;
    cut.arc(a).corner = own ^ 1U;
    const hsp::SurfaceInvariant found = checked();
    if (found == hsp::SurfaceInvariant::none) return 100 + a;
    cut.arc(a).corner = own;
  }
  return checked() == hsp::SurfaceInvariant::none ? all_hold : 4;
}

// Corners that get another number in all of their patches: then two rings are one corner. And creases that overlap.
inline uint32_t wrong_rings_are_named() {
  uint32_t corners = 0, pairs = 0;
  for (uint32_t seed = 0; seed < 400 && (corners < 4 || pairs < 4); ++seed) {
    if (!small_surface().build(random_scene(seed))) return seed;
    const hsp::Surface &surface = small_surface().builder().surface();
    hsp::CutPatches cut = surface.cut_patches();
    const uint32_t first = 3 * small_union().boundary().vertex_count() + 2 * surface.cusped_circles().count();
    if (cut.crease_corners().size() > 1) {
      for (uint32_t a = 0; a < cut.arc_count(); ++a) {
        if (cut.arc(a).corner == first + 1) cut.arc(a).corner = first;
      }
      if (checked() != hsp::SurfaceInvariant::rings) return 1000 + seed;
      ++corners;
      continue;
    }
    for (uint32_t k = 0; k < cut.creases().size(); ++k) {
      hsp::PatchArc &arc = cut.arc(cut.creases().member(k));
      uint32_t same = 0;
      for (const uint32_t b : cut.arcs_of_vertex(cut.arc(arc.twin).across)) same += cut.arc(b).across == arc.across;
      if (same < 2) continue;
      const double angle = arc.angle;
      arc.angle = cut.arc(arc.twin).angle = 2 * hsp::pi - 1e-3;
      const hsp::SurfaceInvariant found = checked();
      arc.angle = cut.arc(arc.twin).angle = angle;
      if (found != hsp::SurfaceInvariant::creases) return 2000 + seed;
      ++pairs;
    }
  }
  return corners > 0 && pairs > 0 ? all_hold : 3000 + pairs;
}

// A piece that is not what is left of its patch; a patch that is not what is measured of it.
inline uint32_t wrong_sums_are_named() {
  if (!small_surface().build(three_throat)) return 0;
  const hsp::CutPatches &cut = small_surface().builder().surface().cut_patches();
  hsp::PatchPiece &piece = const_cast<hsp::PatchPiece &>(cut.piece(0));
  hsp::ConcavePatch &patch = const_cast<hsp::ConcavePatch &>(cut.patch(piece.vertex));
  struct Place {
    double &of_piece, &of_patch;
  };
  const Place places[] = {{piece.area, patch.area}, {piece.volume, patch.volume}};
  for (const Place &place : places) {
    const double sound = place.of_piece;
    place.of_piece = sound * (1 + 1e-8);
    if (checked() != hsp::SurfaceInvariant::areas) return 1;
    place.of_patch = place.of_piece;
    if (checked() != hsp::SurfaceInvariant::totals) return 2;
    place.of_piece = place.of_patch = sound;
  }
  return checked() == hsp::SurfaceInvariant::none ? all_hold : 3;
}

// Both cut patches of the throat, of one piece each: what its pieces are is not what it is, or both are wrong.
inline uint32_t every_wrong_patch_is_named() {
  if (!small_surface().build(three_throat)) return 0;
  const hsp::Surface &surface = small_surface().builder().surface();
  const hsp::CutPatches &cut = surface.cut_patches();
  const hsp::SurfaceMap map(small_union().balls(), small_union().boundary(), surface);
  const auto finds = [&](hsp::SurfaceInvariant invariant, uint32_t id) {
    const hsp::SurfaceViolation found = hsp::check_surface({small_union().balls(), small_union().boundary(), surface});
    return found.invariant == invariant && found.id == id;
  };
  const uint32_t vertices = small_union().boundary().vertex_count();
  for (uint32_t v = 0; v < vertices; ++v) {
    if (cut.pieces(v).size() != 1) return 100 + v;
    // Its memory is the builder's.
    double &of_piece = const_cast<hsp::PatchPiece &>(cut.piece(cut.pieces(v).first)).area;
    double &of_patch = const_cast<hsp::ConcavePatch &>(cut.patch(v)).area;
    const double right = of_piece;
    of_piece *= 1.001;
    if (!finds(hsp::SurfaceInvariant::areas, v)) return 200 + v;
    of_patch += of_piece - right;
    if (!finds(hsp::SurfaceInvariant::closure, map.concave_patch(v, cut.pieces(v).first))) return 300 + v;
    of_patch -= of_piece - right;
    of_piece = right;
  }
  return vertices == 2 && map.concave_patch(1, cut.pieces(1).first) + 1 == map.patch_count() ? all_hold : 1;
}

// The probe at (6, 3, 6) lies in the plane of three of its balls' centres, and touches two more, which are equal: the
// surface is closed all the same.
constexpr SurfaceScene flat_and_tied = {8,
                                        {{4, 12, 0, 3},
                                         {8, 6, 0, 3},
                                         {8, 12, 0, 7},
                                         {4, 6, 12, 3},
                                         {4, 12, 12, 3},
                                         {8, 0, 12, 3},
                                         {0, 0, 12, 5},
                                         {4, 6, 12, 3}},
                                        4};
inline uint32_t ties_are_closed() {
  if (!small_surface().build(flat_and_tied)) return 0;
  return small_surface().builder().surface().is_of_actual_balls() && checked() == hsp::SurfaceInvariant::none ? all_hold
                                                                                                              : 1;
}

// Balls apart, without a vertex: their shells need memory all the same.
inline uint32_t more_faces_than_probes() {
  SurfaceScene apart{8, {}, usual_probe};
  for (uint32_t k = 0; k < 8; ++k)
    apart.ball[k] = {1000000000 * static_cast<int32_t>(k % 2), 1000000000 * static_cast<int32_t>(k / 2 % 2),
                     1000000000 * static_cast<int32_t>(k / 4), carbon};
  if (!small_surface().build(apart, {0, 8, 0, 0, 0, 0})) return 0;
  if (small_surface().builder().surface().shells().count() != 8) return 1;
  return checked() == hsp::SurfaceInvariant::none ? all_hold : 2;
}

inline constexpr Check surface_surface_check[] = {{"sound_surfaces", sound_surfaces},
                                                  {"euler_numbers", euler_numbers},
                                                  {"mistakes_are_named", mistakes_are_named},
                                                  {"wrong_rings_are_named", wrong_rings_are_named},
                                                  {"wrong_sums_are_named", wrong_sums_are_named},
                                                  {"every_wrong_patch_is_named", every_wrong_patch_is_named},
                                                  {"ties_are_closed", ties_are_closed},
                                                  {"more_faces_than_probes", more_faces_than_probes}};

}  // namespace cases
