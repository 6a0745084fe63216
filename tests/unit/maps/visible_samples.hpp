// Points of a curve and whether they are hidden, asked ball by ball, held against arcs.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "maps/hidden_intervals.hpp"
#include "placed_balls.hpp"

// By how much the point is below the front of a ball other than the two; negative if it is above all of them or beside.
inline double hidden_by(hsp::Span<const hsp::SeenBall> balls, const hsp::Vec3 &p, uint32_t one, uint32_t two) {
  double most = -1e300;
  for (uint32_t k = 0; k < balls.size(); ++k) {
    const hsp::SeenBall &ball = balls[k];
    const double squared = ball.r * ball.r - (p.x - ball.x) * (p.x - ball.x) - (p.y - ball.y) * (p.y - ball.y);
    if (k != one && k != two && squared > 0) most = std::max(most, ball.z + std::sqrt(squared) - p.z);
  }
  return most;
}

// Compares many samples from -end to end, and returns how many were compared. near_end: what the samples keep away from
// the ends of arcs.
template <class Point>
uint32_t expect_visible_where_arcs_are(const std::vector<hsp::MapArc> &arcs, hsp::Span<const hsp::SeenBall> balls,
                                       double end, uint32_t one, uint32_t two, Point point) {
  uint32_t compared = 0;
  for (int k = 0; k < 400; ++k) {
    const double t = -end + 2 * end * (k + 0.5) / 400;
    bool in_arc = false, near_end = false;
    for (const hsp::MapArc &arc : arcs)
      for (const double turned : {t, t - 2 * hsp::pi}) {
        in_arc |= turned > arc.from && turned < arc.to;
        near_end |= std::abs(turned - arc.from) < 1e-4 || std::abs(turned - arc.to) < 1e-4;
      }
    if (near_end) continue;
    const double hidden = hidden_by(balls, point(t), one, two);
    if (std::abs(hidden) < 1e-6) continue;
    ++compared;
    EXPECT_EQ(in_arc, hidden < 0) << "t = " << t;
  }
  return compared;
}
