// Faults that only lengths and areas can find: vertices off their spheres, a face taken for two, a surface that does
// not close. No invariant of the structure knows better.
#pragma once

#include <initializer_list>
#include <limits>

#include "boundary/components.hpp"
#include "measure/boundary_metric_check.hpp"
#include "small_scenes.hpp"

namespace cases {

inline hsp::BoundaryViolation metric_violation() {
  return hsp::check_boundary_metric(small_union().balls(), small_union().boundary());
}
inline bool structure_is_correct() {
  return hsp::check_boundary(small_union().balls(), small_union().boundary(), small_union().builder().scratch())
             .invariant == hsp::BoundaryInvariant::none;
}

inline uint32_t correct_boundaries_pass() {
  return first_failing_scene([](const Scene &c) {
    return small_union().build(c.ball, c.n) && metric_violation().invariant == hsp::BoundaryInvariant::none;
  });
}

// Balls that touch in one point of a third, an arc of nearly a whole circle, four balls through one point, and small
// balls on large ones: where rounding is worst.
struct HardUnion {
  uint32_t n;
  SmallBall ball[4];
};
constexpr HardUnion hard_unions[] = {
    {3, {{0, 0, 0, 1000000000}, {1000000000, 0, 0, 1000000000}, {500000000, 866025404, 0, 3}}},
    {3, {{0, 0, 0, 5}, {10, 0, 0, 5}, {5, 1, 0, 1}}},
    {3, {{0, 0, 0, 5}, {8, 0, 0, 5}, {4, 3, 0, 1}}},
    {4, {{0, 0, 0, 5}, {4, 0, 0, 5}, {4, 3, 0, 5}, {0, 3, 0, 5}}},
    {4,
     {{0, 0, 0, 1000000000}, {1000000000, 0, 0, 3}, {1000000000, 2, 1, 3}, {-1000000000, -1000000000, 0, 1000000000}}}};

inline uint32_t hard_boundaries_pass() {
  return first_failing(hard_unions, [](const HardUnion &c) {
    return small_union().build(c.ball, c.n) && metric_violation().invariant == hsp::BoundaryInvariant::none;
  });
}

// Positions are computed from the roots of the discriminants.
inline uint32_t vertices_off_their_spheres() {
  return first_failing_scene([](const Scene &c) {
    for (const double factor : {1.001, 0.999, 1 + 0x1p-36, -1.0, 0.0, std::numeric_limits<double>::quiet_NaN()}) {
      for (uint32_t v = 0; v < c.vertices; ++v) {
        if (!small_union().build(c.ball, c.n)) return false;
        small_union().builder().arrays().root_discriminant[v] *= factor;
        // A wrong sign is the other common point of the three spheres.
        const hsp::BoundaryViolation found = metric_violation();
        if (!structure_is_correct()) return false;
        if (factor == -1.0 ? found.invariant == hsp::BoundaryInvariant::none
                           : found.invariant != hsp::BoundaryInvariant::positions || found.id != v) {
          return false;
        }
      }
    }
    return true;
  });
}

// Two small balls on a large one, whose rounding hides that their common point with it is not quite on them: their
// areas show it. Circles may be smaller than a step of the lattice.
inline uint32_t vertices_off_small_spheres() {
  constexpr SmallBall unions[][3] = {{{0, 0, 0, 1000000000}, {1000000000, 0, 0, 3}, {1000000001, 2, 1, 3}},
                                     {{0, 0, 0, 1000000000}, {1000000000, 0, 0, 3}, {1000000001, 4, 4, 3}}};
  return first_failing(unions, [](const SmallBall(&balls)[3]) {
    if (!small_union().build(balls, 3)) return false;
    hsp::BoundaryArrays &arrays = small_union().builder().arrays();
    if (arrays.vertices.size() == 0) return false;
    arrays.root_discriminant[0] *= 1 + 1e-6;
    const hsp::BoundaryViolation found = metric_violation();
    const bool small = found.id < 3 && found.id != small_union().grid().grid_index(0);
    return found.invariant == hsp::BoundaryInvariant::areas && small;
  });
}

// A capsule of three balls in a row; the face of the middle one is a band between two circles.
constexpr SmallBall capsule[] = {{0, 0, 0, 500}, {600, 0, 0, 500}, {1200, 0, 0, 500}};

// The band taken for two faces makes two closed surfaces; but they have more area than their sphere.
inline uint32_t faces_cut_in_two() {
  if (!small_union().build(capsule, 3)) return 0;
  hsp::BoundaryArrays &arrays = small_union().builder().arrays();
  const uint32_t middle = small_union().grid().grid_index(1);
  const uint32_t band = arrays.first[middle].face;
  const uint32_t cut = arrays.first[middle].loop + 1;
  // The new face follows the band; later faces move up by one.
  for (uint32_t face = arrays.face_count++; face > band + 1; --face) arrays.faces[face] = arrays.faces[face - 1];
  for (uint32_t ball = middle + 1; ball <= 3; ++ball) ++arrays.first[ball].face;
  for (uint32_t loop = cut + 1; loop < arrays.loop_count; ++loop) {
    if (arrays.loop_face[loop] > band) ++arrays.loop_face[loop];
  }
  arrays.loop_face[cut] = band + 1;
  arrays.faces[band + 1] = {middle, cut, hsp::no_id};
  hsp::Patience endless;
  hsp::find_shells(small_union().boundary(), arrays, small_union().builder().scratch(), endless);
  const hsp::BoundaryViolation found = metric_violation();
  const bool conditions[] = {arrays.shell_count == 2, structure_is_correct(),
                             found.invariant == hsp::BoundaryInvariant::areas, found.id == middle};
  return first_false(conditions);
}

// A loop too many takes away the area of half a sphere: more than a small face has.
inline uint32_t faces_with_a_loop_too_many() {
  constexpr SmallBall balls[] = {{0, 0, 0, 500}, {400, 0, 0, 800}};
  if (!small_union().build(balls, 2)) return 0;
  const uint32_t small = small_union().grid().grid_index(0);
  ++small_union().builder().arrays().first[small + 1].loop;
  const hsp::BoundaryViolation found = metric_violation();
  const bool conditions[] = {found.invariant == hsp::BoundaryInvariant::areas, found.id == small};
  return first_false(conditions);
}

// One of the band's circles counted twice and the other not at all leaves its area, but the surface does not close.
inline uint32_t surfaces_that_do_not_close() {
  if (!small_union().build(capsule, 3)) return 0;
  hsp::BoundaryArrays &arrays = small_union().builder().arrays();
  const uint32_t first = arrays.first[small_union().grid().grid_index(1)].closed_half_edge;
  arrays.closed_half_edge[first] = arrays.closed_half_edge[first + 1];
  const bool conditions[] = {metric_violation().invariant == hsp::BoundaryInvariant::closure};
  return first_false(conditions);
}

inline constexpr Check measure_boundary_metric_check[] = {{"correct_boundaries_pass", correct_boundaries_pass},
                                                          {"hard_boundaries_pass", hard_boundaries_pass},
                                                          {"vertices_off_their_spheres", vertices_off_their_spheres},
                                                          {"vertices_off_small_spheres", vertices_off_small_spheres},
                                                          {"faces_cut_in_two", faces_cut_in_two},
                                                          {"faces_with_a_loop_too_many", faces_with_a_loop_too_many},
                                                          {"surfaces_that_do_not_close", surfaces_that_do_not_close}};

}  // namespace cases
