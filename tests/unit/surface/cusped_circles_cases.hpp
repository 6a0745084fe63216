// Circles with cusps and without, with arcs and whole.
#pragma once

#include "small_surface.hpp"
#include "surface/cusped_circles.hpp"

namespace cases {

// Two balls far enough from each other for cusps; the same with a third ball that covers a part of their circle.
constexpr SurfaceScene spindle = {2, {{0, 0, 0, carbon}, {610000000, 0, 0, carbon}}, usual_probe};
constexpr SurfaceScene cut_spindle = {
    3, {{0, 0, 0, carbon}, {610000000, 0, 0, carbon}, {305000000, 260000000, 0, 100000000}}, usual_probe};

struct CuspCase {
  const SurfaceScene *scene;
  uint32_t circles, whole, arcs;
};
constexpr CuspCase cusp_cases[] = {
    {&three_throat, 0, 0, 0}, {&spindle, 1, 1, 0}, {&cut_spindle, 1, 0, 1}, {&void_in_tetrahedron, 0, 0, 0}};

inline uint32_t circles_with_cusps() {
  return first_failing(cusp_cases, [](const CuspCase &c) {
    if (!small_union().build(c.scene->ball, c.scene->n, c.scene->probe)) return false;
    alignas(64) static unsigned char memory[1024];
    hsp::Workspace workspace(memory, sizeof memory);
    hsp::CuspedCircles cusped;
    cusped.carve(workspace, 4);
    hsp::Patience endless;
    cusped.find({small_union().balls(), small_union().boundary()}, endless);
    if (cusped.required() != c.circles || cusped.saddles() != c.whole + c.arcs || cusped.arcs() != c.arcs) return false;
    for (uint32_t k = 0; k < cusped.count(); ++k) {
      const bool is_whole = cusped.half_edges(k).empty();
      const uint32_t found = is_whole ? cusped.of_circle(cusped.element(k).closed_half_edge().circle())
                                      : cusped.of_arc(cusped.ball(k, 0), cusped.ball(k, 1));
      if (found != k || is_whole != (c.whole == 1)) return false;
    }
    return cusped.of_arc(0, 99) == hsp::no_id && cusped.of_circle(99) == hsp::no_id;
  });
}

inline uint32_t too_many_are_counted() {
  if (!small_union().build(spindle.ball, 2, spindle.probe)) return 0;
  hsp::CuspedCircles none;
  hsp::Patience endless;
  none.find({small_union().balls(), small_union().boundary()}, endless);
  return none.required() == 1 && none.count() == 0 ? all_hold : 1;
}

inline constexpr Check surface_cusped_circles[] = {{"circles_with_cusps", circles_with_cusps},
                                                   {"too_many_are_counted", too_many_are_counted}};

}  // namespace cases
