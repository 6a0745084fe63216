// Small unions with the numbers of their parts, counted by hand.
#pragma once

#include "small_union.hpp"

namespace cases {

// The topology's numbers of vertices and edges, and of simple faces with two, three, four and six edges.
struct CutParts {
  uint32_t vertices, edges, with_two, with_three, with_four, with_six;

  constexpr uint32_t faces() const { return with_two + with_three + with_four + with_six; }
};
struct Scene {
  uint32_t n;
  SmallBall ball[8];
  uint32_t vertices, circles, faces, shells, components;
  // By ball: w whole sphere, e exposed in part, c contained in one ball, b buried by several.
  const char *states;
  CutParts cut;
};
// In general position.
constexpr Scene scenes[] = {
    // A whole sphere is cut along one great circle, from pole to pole and back.
    {1, {{1, 2, 3, 4}}, 0, 0, 1, 1, 1, "w", {2, 2, 2, 0, 0, 0}},
    // A circle has two halves.
    {2, {{0, 0, 0, 500}, {600, 0, 0, 500}}, 0, 1, 2, 1, 1, "ee", {2, 2, 2, 0, 0, 0}},
    {2, {{0, 0, 0, 500}, {5000, 0, 0, 500}}, 0, 0, 2, 2, 2, "ww", {4, 4, 4, 0, 0, 0}},
    {2, {{0, 0, 0, 500}, {100, 0, 0, 100}}, 0, 0, 1, 1, 1, "wc", {2, 2, 2, 0, 0, 0}},
    // A face with two loops that one great circle joins, by an arc over each side: halves of four edges. The cut arcs
    // end where the circles have their halves.
    {3, {{0, 0, 0, 500}, {600, 0, 0, 500}, {1200, 0, 0, 500}}, 0, 2, 3, 1, 1, "eee", {4, 6, 2, 0, 2, 0}},
    // Loops of arcs, none of them cut.
    {3, {{0, 0, 0, 1000}, {1000, 0, 0, 1000}, {500, 800, 0, 1000}}, 2, 0, 3, 1, 1, "eee", {2, 3, 3, 0, 0, 0}},
    {4,
     {{0, 0, 0, 1000}, {1000, 0, 0, 1000}, {500, 800, 0, 1000}, {500, 300, 800, 1000}},
     4,
     0,
     4,
     1,
     1,
     "eeee",
     {4, 6, 0, 4, 0, 0}},
    {4,
     {{0, 0, 0, 1000}, {1000, 0, 0, 1000}, {500, 866, 0, 300}, {500, -866, 0, 300}},
     4,
     0,
     4,
     1,
     1,
     "eeee",
     {4, 6, 2, 0, 2, 0}},
    // Three balls in a ring: a torus. On each two great circles meet in both poles: four lunes, with half a circle on
    // four of their sides.
    {3, {{0, 0, 0, 550}, {1000, 0, 0, 550}, {500, 866, 0, 550}}, 0, 3, 3, 1, 1, "eee", {12, 24, 3, 0, 6, 3}},
    // Six around a void: both common points of each of the eight triples are free.
    {6,
     {{1000, 0, 0, 850},
      {-1000, 0, 0, 850},
      {0, 1000, 0, 850},
      {0, -1000, 0, 850},
      {0, 0, 1000, 850},
      {0, 0, -1000, 850}},
     16,
     0,
     12,
     2,
     1,
     "eeeeee",
     {16, 24, 0, 0, 12, 0}},
    // The same with a ball in the void, and one beside it.
    {8,
     {{1000, 0, 0, 850},
      {-1000, 0, 0, 850},
      {0, 1000, 0, 850},
      {0, -1000, 0, 850},
      {0, 0, 1000, 850},
      {0, 0, -1000, 850},
      {0, 0, 0, 100},
      {9000, 0, 0, 10}},
     16,
     0,
     14,
     4,
     3,
     "eeeeeeww",
     {20, 28, 4, 0, 12, 0}}};

// Nothing, ties, buried balls, and bumps on a large ball.
constexpr Scene special_scenes[] = {
    {0, {}, 0, 0, 0, 0, 0, "", {0, 0, 0, 0, 0, 0}},
    {1, {{1, 2, 3, 0}}, 0, 0, 1, 1, 1, "w", {2, 2, 2, 0, 0, 0}},
    // Of equal balls the first contains the other. Balls of one centre are no tie.
    {2, {{0, 0, 0, 5}, {0, 0, 0, 5}}, 0, 0, 1, 1, 1, "wc", {2, 2, 2, 0, 0, 0}},
    {2, {{0, 0, 0, 3}, {0, 0, 0, 5}}, 0, 0, 1, 1, 1, "cw", {2, 2, 2, 0, 0, 0}},
    // Balls that touch from outside meet in a circle. From inside the small one is inside, and so is a point.
    {2, {{0, 0, 0, 5}, {10, 0, 0, 5}}, 0, 1, 2, 1, 1, "ee", {2, 2, 2, 0, 0, 0}},
    {2, {{0, 0, 0, 5}, {3, 0, 0, 2}}, 0, 0, 1, 1, 1, "wc", {2, 2, 2, 0, 0, 0}},
    {2, {{0, 0, 0, 5}, {-3, 0, 0, 2}}, 0, 0, 1, 1, 1, "wc", {2, 2, 2, 0, 0, 0}},
    {2, {{0, 0, 0, 5}, {-5, 0, 0, 0}}, 0, 0, 1, 1, 1, "wc", {2, 2, 2, 0, 0, 0}},
    // Each half of the first ball lies in one of the two others.
    {3, {{0, 0, 0, 5}, {4, 0, 0, 7}, {-4, 0, 0, 7}}, 0, 1, 2, 1, 1, "bee", {2, 2, 2, 0, 0, 0}},
    {3, {{0, 0, 0, 10}, {1, 0, 0, 2}, {20, 0, 0, 4}}, 0, 0, 2, 2, 2, "wcw", {4, 4, 4, 0, 0, 0}},
    // Two bumps joined by one great circle: on one side, over the poles, and on the poles.
    {3, {{0, 0, 0, 100}, {60, 0, 80, 9}, {60, 0, -80, 9}}, 0, 2, 3, 1, 1, "eee", {4, 6, 2, 0, 2, 0}},
    {3, {{0, 0, 0, 100}, {0, 0, 100, 9}, {0, 0, -100, 9}}, 0, 2, 3, 1, 1, "eee", {4, 6, 2, 0, 2, 0}},
    // Two circles that are not cut where both have their halves; the second set lies in one cube of the grid.
    {3, {{0, 0, 0, 100}, {-100, 0, 0, 60}, {96, 28, 0, 9}}, 0, 2, 3, 1, 1, "eee", {6, 8, 1, 0, 2, 1}},
    {3, {{300, 300, 300, 100}, {220, 300, 360, 60}, {396, 328, 300, 9}}, 0, 2, 3, 1, 1, "eee", {6, 8, 1, 0, 2, 1}},
    // A circle and a loop of two arcs, one of which is cut.
    {4,
     {{0, 0, 0, 1000}, {1000, 0, 0, 1000}, {500, 800, 0, 1000}, {-1500, 0, 0, 600}},
     2,
     1,
     4,
     1,
     1,
     "eeee",
     {6, 9, 2, 0, 2, 1}},
    // Two great circles that meet in both poles.
    {3, {{0, 0, 0, 100}, {100, 0, 0, 9}, {0, 100, 0, 9}}, 0, 2, 3, 1, 1, "eee", {6, 10, 3, 0, 2, 1}}};

// The index of the first scene of either table for which holds(scene) is false, special ones from 1000 on.
template <class Holds>
uint32_t first_failing_scene(Holds holds) {
  const uint32_t failing = first_failing(scenes, holds);
  if (failing != all_hold) return failing;
  const uint32_t special = first_failing(special_scenes, holds);
  return special == all_hold ? all_hold : 1000 + special;
}

}  // namespace cases
