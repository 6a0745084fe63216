// Where vertical lines cut a ball.
#pragma once

#include "cases.hpp"
#include "exact/vertical_order.hpp"

namespace cases {

inline uint32_t lines_hit_closed_balls_alone() {
  constexpr hsp::exact::LatticeBall ball{{7, -8, 100}, 5, 0};
  uint32_t line = 0;
  for (int64_t dx = -6; dx <= 6; ++dx) {
    for (int64_t dy = -6; dy <= 6; ++dy, ++line) {
      hsp::exact::VerticalCut cut{-1, -1};
      const bool hits = dx * dx + dy * dy <= 25;
      if (cut_vertically({7 + dx, -8 + dy, 40}, ball, cut) != hits) return line;
      if (hits && (cut.below != 60 || cut.power != 25 - dx * dx - dy * dy)) return line;
    }
  }
  return all_hold;
}

// Squares of differences like these leave 64 bits: 2^32 squared is 0 modulo 2^64.
constexpr int64_t far_lines[] = {INT64_C(1) << 32, -(INT64_C(1) << 32), INT64_C(1) << 50, -(INT64_C(1) << 50)};

inline uint32_t far_lines_miss() {
  return first_failing(far_lines, [](int64_t far) {
    constexpr hsp::exact::LatticeBall ball{{7, -8, 100}, 5, 0};
    hsp::exact::VerticalCut cut{};
    return !cut_vertically({7 + far, -8, 40}, ball, cut) && !cut_vertically({7, -8 + far, 40}, ball, cut);
  });
}

inline uint32_t lines_hit_points() {
  constexpr hsp::exact::LatticeBall point{{1, 2, 3}, 0, 0};
  hsp::exact::VerticalCut cut{};
  const bool conditions[] = {cut_vertically({1, 2, 0}, point, cut), cut.below == 3, cut.power == 0,
                             !cut_vertically({1, 3, 0}, point, cut)};
  return first_false(conditions);
}

inline constexpr Check exact_vertical_order[] = {{"lines_hit_closed_balls_alone", lines_hit_closed_balls_alone},
                                                 {"far_lines_miss", far_lines_miss},
                                                 {"lines_hit_points", lines_hit_points}};

}  // namespace cases
