// A view handed out to be painted: its pieces with their arcs, and the box around them.
#pragma once

#include "picture/painted_paths.hpp"
#include "small_scenes.hpp"
#include "small_view.hpp"

namespace cases {

struct Seen {
  uint32_t n;
  SmallBall ball[3];
  hsp::ViewBox box;  // around the middle of the centres
};
constexpr Seen seen_boxes[] = {
    {0, {}, {{0, 0}, {0, 0}, 0, 0}},
    {1, {{70, -80, 90, 10}}, {{-10, -10}, {10, 10}, 0, 0}},
    {2, {{0, 0, 0, 10}, {100, 40, 60, 30}}, {{-60, -30}, {80, 50}, -30, 30}},
    {3, {{60, 0, 0, 10}, {-20, 0, 100, 50}, {0, 200, 40, 5}}, {{-90, -150}, {50, 105}, -50, 50}},
    // Hidden balls take no room, nor does a ball without a radius.
    {2, {{0, 0, 0, 10}, {100, 60, -40, 0}}, {{-60, -40}, {-40, -20}, 20, 20}},
    {2, {{0, 0, 0, 10}, {-100, -60, 40, 0}}, {{40, 20}, {60, 40}, -20, -20}},
    {2, {{0, 0, 0, 10}, {0, 0, 40, 20}}, {{-20, -20}, {20, 20}, 20, 20}}};

inline uint32_t boxes_around_silhouettes() {
  return first_failing(seen_boxes, [](const Seen &c) {
    if (!small_view().succeeds(c.ball, c.n, {})) return false;
    const hsp::ViewBox box = hsp::box_of(small_view().balls(), hsp::paths_of(small_view().view()));
    return box.low[0] == c.box.low[0] && box.low[1] == c.box.low[1] && box.high[0] == c.box.high[0] &&
           box.high[1] == c.box.high[1] && box.depth_low == c.box.depth_low && box.depth_high == c.box.depth_high;
  });
}

inline bool same_arc(const hsp::ProjectedArc &a, const hsp::ProjectedArc &b) {
  bool same = a.from == b.from && a.to == b.to && a.other_ball == b.other_ball;
  for (int k = 0; k < 2; ++k) {
    same = same && a.ellipse.centre[k] == b.ellipse.centre[k] && a.ellipse.major[k] == b.ellipse.major[k] &&
           a.ellipse.minor[k] == b.ellipse.minor[k] && a.start[k] == b.start[k] && a.end[k] == b.end[k];
  }
  return same;
}

// The outlines are the arcs of the pieces, one by one, and lines run along them.
inline uint32_t paths_of_views() {
  return first_failing(scenes, [](const Scene &c) {
    if (!small_view().succeeds(c.ball, c.n, seen_from(3, 1, 2))) return false;
    const hsp::View &view = small_view().view();
    const hsp::PaintedPaths paths = hsp::paths_of(view);
    if (paths.size() != view.pieces.size() || paths.have_own_lines() || &paths.frame() != &view.frame) return false;
    bool holds = true;
    for (uint32_t p = 0; p < paths.size(); ++p) {
      static hsp::ProjectedArc expected[200];
      static bool ends[200][2];
      uint32_t count = 0, visited = 0;
      hsp::visit_arcs(small_view().balls(), view, p, [&](const hsp::ProjectedArc &arc, bool first, bool last) {
        ends[count][0] = first;
        ends[count][1] = last;
        expected[count++] = arc;
      });
      const auto compare = [&](const hsp::ProjectedArc &arc, bool first, bool closes) {
        holds = holds && visited < count && same_arc(arc, expected[visited]) && first == ends[visited][0] &&
                closes == ends[visited][1];
        ++visited;
      };
      paths.visit(small_view().balls(), p, hsp::PathPart::outline, compare);
      holds = holds && paths.ball_of(p) == view.pieces[p].ball && visited == count && count > 0;
    }
    return holds;
  });
}

inline constexpr Check picture_painted_paths[] = {{"boxes_around_silhouettes", boxes_around_silhouettes},
                                                  {"paths_of_views", paths_of_views}};

}  // namespace cases
