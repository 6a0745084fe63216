// Concave patches against known values, and limits.
#pragma once

#include "small_surface.hpp"

namespace cases {

struct PatchCase {
  const SurfaceScene *scene;
  double concave;  // area of all of them, in 1e-16 square steps
  uint32_t cut, cusped;
};
constexpr PatchCase patch_cases[] = {{&three_throat, 6.35405963625, 2, 0},
                                     {&three_almost, 1.12838415294, 2, 0},
                                     {&void_in_tetrahedron, 22.6266317068, 8, 0},
                                     {&four_through_a_point, 4.740968667, 0, 0}};

inline uint32_t known_patches() {
  return first_failing(patch_cases, [](const PatchCase &c) {
    if (!small_surface().build(*c.scene)) return false;
    const hsp::Surface &surface = small_surface().builder().surface();
    double area = 0;
    for (uint32_t v = 0; v < small_union().boundary().vertex_count(); ++v) area += surface.patch(v).area;
    const hsp::SurfaceCounts counts = surface.counts();
    return near(area * 1e-16, c.concave, 2e-9) && counts.cut_patches == c.cut && counts.cusped_arcs == c.cusped &&
           counts.rounded_patches == 0 && !surface.is_of_actual_balls();
  });
}

// A limit that is too small, the numbers that suffice, and that nothing less does.
inline uint32_t limits_to_retry_with() {
  struct Limited {
    hsp::SurfaceLimits limits, needed;
    bool suffices;
  };
  constexpr Limited limited[] = {
      {{2, 3, 1, 2, 8, 0}, {2, 3, 1, 2, 8, 0}, true},  {{1, 3, 1, 2, 8, 0}, {2, 3, 0, 0, 0, 0}, false},
      {{2, 3, 0, 2, 8, 0}, {2, 3, 1, 0, 0, 0}, false}, {{2, 3, 1, 1, 8, 0}, {2, 3, 1, 2, 8, 0}, false},
      {{2, 3, 1, 2, 7, 0}, {2, 3, 1, 2, 8, 0}, false}, {{60, 9, 30, 9, 99, 0}, {2, 3, 1, 2, 8, 0}, true}};
  return first_failing(limited, [](const Limited &c) {
    const bool built = small_surface().build(three_throat, c.limits);
    const hsp::SurfaceBuilder &builder = small_surface().builder();
    const hsp::SurfaceLimits retry = builder.retry_limits();
    return built == c.suffices && (built || small_surface().status() == hsp::Status::capacity) &&
           builder.needed().vertices == c.needed.vertices && builder.needed().neighbours == c.needed.neighbours &&
           builder.needed().pieces == c.needed.pieces && builder.needed().arcs == c.needed.arcs &&
           builder.needed().cusped_circles == c.needed.cusped_circles && retry.vertices >= c.limits.vertices &&
           retry.neighbours >= c.limits.neighbours;
  });
}

inline uint32_t without_a_probe() {
  SurfaceScene scene = three_throat;
  scene.probe = 0;
  for (SmallBall &ball : scene.ball) ball.r += usual_probe;
  if (!small_surface().build(scene)) return 0;
  for (uint32_t v = 0; v < 2; ++v) {
    if (small_surface().builder().surface().patch(v).area != 0) return 1;
  }
  return small_surface().builder().surface().counts().cusped_arcs == 0 ? all_hold : 2;
}

// Balls of a lattice, with four and more spheres through a vertex: decided in integers where need be, not refused.
inline uint32_t lattices_have_an_answer() {
  Random random(16);
  for (uint32_t round = 0; round < 200; ++round) {
    SurfaceScene scene{8, {}, static_cast<int32_t>(1 + random.below(8)) * 50};
    for (SmallBall &ball : scene.ball) {
      ball = {100 * static_cast<int32_t>(random.below(3)), 100 * static_cast<int32_t>(random.below(3)),
              100 * static_cast<int32_t>(random.below(3)), 50 * static_cast<int32_t>(random.below(4))};
    }
    if (!small_surface().build(scene)) return round;
  }
  return all_hold;
}

// Two probes 2e-7 of their radius apart: what is between them and the others is known in doubles to a hundredth of it.
constexpr SurfaceScene nearly_tied = {5,
                                      {{99999991, 199999995, 5, 10000000},
                                       {200000006, 200000004, 7, 10000000},
                                       {199999994, 3, 1, 10000000},
                                       {199999991, -6, 99999999, 10000000},
                                       {99999996, -1, 100000010, 10000000}},
                                      200000000};
inline uint32_t imprecise_figures_are_not_taken() {
  if (!small_surface().build(nearly_tied)) return 0;
  const hsp::Surface &surface = small_surface().builder().surface();
  return surface.is_of_actual_balls() && surface.cut_patches().creases().size() > 0 ? all_hold : 1;
}

inline constexpr Check surface_surface_builder[] = {
    {"known_patches", known_patches},
    {"limits_to_retry_with", limits_to_retry_with},
    {"without_a_probe", without_a_probe},
    {"lattices_have_an_answer", lattices_have_an_answer},
    {"imprecise_figures_are_not_taken", imprecise_figures_are_not_taken}};

}  // namespace cases
