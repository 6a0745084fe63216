// Whole views: what is painted last at a point is what is seen there, and limits that suffice.
#pragma once

#include <initializer_list>
#include <limits>

#include "picture/painted_paths.hpp"
#include "small_scenes.hpp"
#include "small_view.hpp"

namespace cases {

constexpr auto outside_farther = hsp::PieceKind::outside_farther, outside_all = hsp::PieceKind::outside_all;
constexpr double view_points[][3] = {{0, 0, 1}, {0, 0, -1}, {3, 1, 2}, {-5, 2, 1}};

// The first of the highest fronts at a point of the view plane, no_id beside all balls or near another front.
inline uint32_t seen_at(double x, double y, bool &certain) {
  const hsp::BallSet &balls = small_view().balls();
  uint32_t best = hsp::no_id;
  double highest = no_front, second = no_front;
  certain = true;
  for (uint32_t i = 0; i < balls.n; ++i) {
    const hsp::Vec3 centre = small_view().view().frame.centre_of(balls, i);
    const double distance = std::sqrt((x - centre.x) * (x - centre.x) + (y - centre.y) * (y - centre.y));
    if (near(distance, balls.r[i], .01 * balls.r[i])) certain = false;
    const double front = front_of(balls, small_view().view().frame, i, x, y);
    second = front > highest ? highest : front > second ? front : second;
    best = front > highest ? i : best;
    highest = front > highest ? front : highest;
  }
  if (best != hsp::no_id && near(highest, second, .05 * static_cast<double>(balls.largest_radius))) certain = false;
  return best;
}

inline bool paints_what_is_seen() {
  const hsp::View &view = small_view().view();
  const hsp::BallSet &balls = small_view().balls();
  const hsp::ViewBox box = hsp::box_of(balls, hsp::paths_of(view));
  uint32_t compared = 0;
  for (int row = 0; row < 20; ++row) {
    for (int column = 0; column < 20; ++column) {
      const double x = box.low[0] + (box.high[0] - box.low[0]) * (column + .437) / 20;
      const double y = box.low[1] + (box.high[1] - box.low[1]) * (row + .561) / 20;
      bool certain;
      const uint32_t expected = seen_at(x, y, certain);
      if (!certain) continue;
      ++compared;
      uint32_t painted = hsp::no_id;
      for (uint32_t p = 0; p < view.pieces.size(); ++p) {
        const int times = winding_number(balls, view, p, x, y);
        if (times != 0 && times != 1) return false;
        if (times == 1) painted = view.pieces[p].ball;
      }
      if (painted != expected) return false;
    }
  }
  return compared > 300;
}

inline uint32_t what_is_painted_last_is_seen() {
  return first_failing(scenes, [](const Scene &c) {
    for (const double(&v)[3] : view_points) {
      for (const hsp::PieceKind kind : {outside_farther, outside_all}) {
        for (const bool all_balls : {false, true}) {
          if (!small_view().succeeds(c.ball, c.n, seen_from(v[0], v[1], v[2], kind, all_balls))) return false;
          if (small_view().builder().kind() != kind || !paints_what_is_seen()) return false;
        }
      }
      // Pieces outside farther balls need no boundary.
      const hsp::ViewRequest request = seen_from(v[0], v[1], v[2], outside_farther);
      if (!small_view().again(request, nullptr) || !paints_what_is_seen()) return false;
    }
    return true;
  });
}

// Which balls have a piece, seen along the z axis, in the order in which they are painted.
struct Painted {
  uint32_t n;
  SmallBall ball[4];
  hsp::PieceKind kind;
  bool all_balls;
  uint32_t pieces, order[4], arcs;
};
constexpr Painted painted[] = {
    {3, {{0, 0, 90, 30}, {100, 0, -70, 30}, {200, 0, 10, 30}}, outside_farther, false, 3, {1, 2, 0}, 3},
    {4, {{0, 0, 3, 9}, {30, 0, 2, 9}, {60, 0, 1, 9}, {90, 0, 4, 9}}, outside_all, false, 4, {2, 1, 0, 3}, 4},
    // Hidden behind another ball: only if all are asked for.
    {2, {{0, 0, 0, 30}, {0, 0, 200, 90}}, outside_farther, false, 1, {1}, 1},
    {2, {{0, 0, 0, 30}, {0, 0, 200, 90}}, outside_farther, true, 2, {0, 1}, 2},
    // One that is not painted cuts no other either.
    {3, {{0, 0, 0, 100}, {95, 0, -1, 15}, {120, 0, 300, 60}}, outside_farther, false, 2, {0, 2}, 2},
    {3, {{0, 0, 0, 100}, {95, 0, -1, 15}, {120, 0, 300, 60}}, outside_farther, true, 3, {1, 0, 2}, 4},
    // Inside another ball, inside two together, or without a radius: never.
    {2, {{0, 0, 0, 30}, {5, 0, 0, 90}}, outside_farther, true, 1, {1}, 1},
    {2, {{0, 0, 0, 30}, {5, 0, 0, 90}}, outside_all, true, 1, {1}, 1},
    {3, {{0, 0, 0, 30}, {20, 0, 1, 50}, {-20, 0, 2, 50}}, outside_farther, true, 2, {1, 2}, 3},
    {2, {{0, 0, 0, 30}, {100, 0, 0, 0}}, outside_farther, true, 1, {0}, 1},
    // The front of the farther ball lies in the nearer one: no part of it is outside all, but it may be painted.
    {2, {{0, 0, 0, 30}, {0, 0, 30, 50}}, outside_farther, true, 2, {0, 1}, 2},
    {2, {{0, 0, 0, 30}, {0, 0, 30, 50}}, outside_all, true, 1, {1}, 1}};

inline uint32_t painted_balls() {
  return first_failing(painted, [](const Painted &c) {
    const hsp::ViewRequest request = seen_from(0, 0, 1, c.kind, c.all_balls);
    if (!small_view().succeeds(c.ball, c.n, request)) return false;
    const hsp::View &view = small_view().view();
    for (int time = 0; time < 2; ++time) {
      if (view.pieces.size() != c.pieces || view.arcs.size() != c.arcs) return false;
      for (uint32_t p = 0; p < c.pieces; ++p) {
        if (small_view().balls().caller[view.pieces[p].ball] != c.order[p]) return false;
      }
      // Once more, over the view that is there.
      if (view.loops.size() > view.arcs.size() || !small_view().again(request, &small_union().boundary())) return false;
    }
    return true;
  });
}

// The needed limits suffice, and a limit below them does not; the counts before the failure are reported.
inline uint32_t needed_limits_suffice() {
  return first_failing(scenes, [](const Scene &c) {
    const hsp::ViewRequest request = seen_from(3, 1, 2);
    if (!small_view().succeeds(c.ball, c.n, request)) return false;
    const hsp::ViewLimits needed = small_view().builder().needed();
    const auto fails_with = [&](const hsp::ViewLimits &limits, const hsp::ViewLimits &told) {
      if (!small_view().build(c.ball, c.n, request, limits)) return false;
      const hsp::ViewLimits &found = small_view().builder().needed();
      return small_view().status() == hsp::Status::capacity && found.balls == told.balls &&
             found.neighbours == told.neighbours && found.arcs == told.arcs;
    };
    if (needed.balls != c.n || needed.arcs != small_view().view().arcs.size()) return false;
    if (!small_view().build(c.ball, c.n, request, needed) || small_view().status() != hsp::Status::ok) return false;
    hsp::ViewLimits limits = needed;
    --limits.balls;
    if (!fails_with(limits, {c.n, 0, 0})) return false;
    limits = needed;
    --limits.arcs;
    if (!fails_with(limits, needed)) return false;
    limits = needed;
    return limits.neighbours-- == 0 || fails_with(limits, {c.n, needed.neighbours, 0});
  });
}

inline uint32_t directions_that_are_none() {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  constexpr double bad[][3] = {{infinite, 0, 1}, {0, -infinite, 1}, {0, 0, std::numeric_limits<double>::quiet_NaN()}};
  constexpr SmallBall ball{0, 0, 0, 5};
  return first_failing(bad, [&](const double(&v)[3]) {
    return small_view().build(&ball, 1, seen_from(v[0], v[1], v[2])) &&
           small_view().status() == hsp::Status::not_finite;
  });
}

inline constexpr Check view_view_builder[] = {{"what_is_painted_last_is_seen", what_is_painted_last_is_seen},
                                              {"painted_balls", painted_balls},
                                              {"needed_limits_suffice", needed_limits_suffice},
                                              {"directions_that_are_none", directions_that_are_none}};

}  // namespace cases
