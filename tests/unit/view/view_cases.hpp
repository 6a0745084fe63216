// Limits of views for a number of balls.
#pragma once

#include "cases.hpp"
#include "view/view.hpp"

namespace cases {

struct DefaultView {
  uint32_t balls;
  hsp::Status status;
  uint32_t neighbours, arcs;
};
constexpr uint32_t most_seen_balls = (hsp::max_count - 64) / 12;
constexpr DefaultView default_views[] = {{0, hsp::Status::ok, 0, 64},
                                         {1, hsp::Status::ok, 1, 76},
                                         {256, hsp::Status::ok, 256, 3136},
                                         {300, hsp::Status::ok, 256, 3664},
                                         {most_seen_balls, hsp::Status::ok, 256, 12 * most_seen_balls + 64},
                                         {most_seen_balls + 1, hsp::Status::range, 0, 0},
                                         {0xFFFFFFFF, hsp::Status::range, 0, 0}};

inline uint32_t default_limits_of_views() {
  return first_failing(default_views, [](const DefaultView &c) {
    hsp::ViewLimits limits;
    if (hsp::default_limits(c.balls, limits) != c.status) return false;
    if (c.status != hsp::Status::ok) return limits.balls == 0;
    return limits.balls == c.balls && limits.neighbours == c.neighbours && limits.arcs == c.arcs &&
           limits.arcs <= hsp::max_count;
  });
}

inline constexpr Check view_view[] = {{"default_limits_of_views", default_limits_of_views}};

}  // namespace cases
