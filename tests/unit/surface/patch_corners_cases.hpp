// Corners and creases where cut patches meet: every one is found from all its sides.
#pragma once

#include "cusped_circles_cases.hpp"

namespace cases {

struct JointCase {
  const SurfaceScene *scene;
  uint32_t creases, crease_corners;
};
constexpr JointCase joint_cases[] = {
    {&three_throat, 1, 0}, {&three_almost, 1, 0}, {&void_in_tetrahedron, 4, 0}, {&cut_spindle, 1, 0}};

inline uint32_t known_joints() {
  return first_failing(joint_cases, [](const JointCase &c) {
    if (!small_surface().build(*c.scene)) return false;
    const hsp::CutPatches &cut = small_surface().builder().surface().cut_patches();
    return cut.creases().size() == c.creases && cut.crease_corners().size() == c.crease_corners;
  });
}

inline SurfaceScene random_scene(uint32_t seed) {
  Random random(seed);
  SurfaceScene scene{8, {}, 140000000 + static_cast<int32_t>(random.below(200000000))};
  for (SmallBall &ball : scene.ball) {
    const auto coordinate = [&random] { return static_cast<int32_t>(random.below(800000000)); };
    ball = {coordinate(), coordinate(), coordinate(), 100000000 + static_cast<int32_t>(random.below(100000000))};
  }
  return scene;
}

// Where a corner or crease lies follows from each of its patches: with the directions of the circles' axes.
inline uint32_t random_sets_are_closed() {
  uint32_t crease_corners = 0;
  uint32_t cusps = 0;
  for (uint32_t seed = 0; seed < 400; ++seed) {
    if (!small_surface().build(random_scene(seed))) return seed;
    const hsp::Surface &surface = small_surface().builder().surface();
    crease_corners += surface.cut_patches().crease_corners().size();
    cusps += surface.cusped_circles().arcs();
    const hsp::CutPatches &patches = surface.cut_patches();
    for (uint32_t a = 0; a < patches.arc_count(); ++a) {
      const hsp::PatchArc &arc = patches.arc(a);
      if (arc.is_side()) {
        if (arc.twin != hsp::no_id) return seed;
        continue;
      }
      const hsp::PatchArc &twin = patches.arc(arc.twin);
      if (twin.twin != a || !near(arc.angle, twin.angle, 1e-6)) return seed;
      if (arc.corner != patches.end_corner(arc.twin) || twin.corner != patches.end_corner(a)) return seed;
    }
  }
  return crease_corners > 20 && cusps > 50 ? all_hold : 1000;
}

// The mean of both ends of a joint that lacks one of its patches.
inline uint32_t what_is_missing_is_open() {
  for (uint32_t seed = 0; seed < 50; ++seed) {
    if (!small_surface().build(random_scene(seed))) return seed;
    const hsp::Surface &surface = small_surface().builder().surface();
    hsp::CutPatches patches = surface.cut_patches();
    for (uint32_t a = 0; a < patches.arc_count(); ++a) {
      for (uint32_t b = 0; b < patches.arc_count(); ++b) {
        patches.arc(b).corner = hsp::no_id;
        patches.arc(b).twin = hsp::no_id;
      }
      const uint32_t across = patches.arc(a).across;
      patches.arc(a).across =
          patches.arc(a).is_side() ? hsp::PatchArc::side((patches.arc(a).slot() + 1) % 3) : (across == 0 ? 1 : 0);
      hsp::Patience endless;
      const bool open = hsp::join_patches(small_union().boundary(), surface.cusped_circles(), endless, patches) > 0;
      if (!open && !patches.arc(a).is_side()) return seed;
      patches.arc(a).across = across;
    }
  }
  return all_hold;
}

inline constexpr Check surface_patch_corners[] = {{"known_joints", known_joints},
                                                  {"random_sets_are_closed", random_sets_are_closed},
                                                  {"what_is_missing_is_open", what_is_missing_is_open}};

}  // namespace cases
