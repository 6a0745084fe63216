// Where vertical lines cut a ball, and sums of roots that are whole, or of numbers next to squares.
#pragma once

#include <initializer_list>

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

// E + T sqrt(root^2 + off) for |T| < 2 root: with E = -T root + more, the part of the root beyond `root` matters only
// if nothing else is left.
constexpr int64_t whole_roots[] = {2, 3, 1000, (INT64_C(1) << 29) + 7, (INT64_C(1) << 30) - 1};

inline uint32_t signs_next_to_squares() {
  return first_failing(whole_roots, [](int64_t root) {
    const int64_t largest = 2 * root - 1;
    for (const int64_t T : {INT64_C(1), INT64_C(-1), largest / 2, largest, -largest}) {
      for (int64_t more = -1; more <= 1; ++more) {
        for (int64_t off = -1; off <= 1; ++off) {
          if (root * root + off >= INT64_C(1) << 60) continue;
          const int64_t rest = T > 0 ? off : -off;
          const int64_t expected = more != 0 ? more : rest;
          if (hsp::exact::sign_with_root(more - T * root, T, root * root + off) != expected) return false;
        }
      }
    }
    return true;
  });
}

// Entries z - sqrt(a) and -sqrt(b), up to whole roots and one step beside them.
inline uint32_t entries_at_whole_roots() {
  return first_failing(whole_roots, [](int64_t root) {
    for (const int64_t other : whole_roots) {
      for (int64_t off = -1; off <= 1; ++off) {
        const int64_t z = root - other + off;
        if (hsp::exact::compare_entries(z, root * root, other * other) != off) return false;
        // A little less than the root moves the entry upwards.
        if (hsp::exact::compare_entries(z, root * root - 1, other * other) != (off == 0 ? 1 : off)) return false;
        if (hsp::exact::compare_entries(z, root * root, other * other - 1) != (off == 0 ? -1 : off)) return false;
      }
    }
    return true;
  });
}

inline constexpr Check exact_vertical_order[] = {{"lines_hit_closed_balls_alone", lines_hit_closed_balls_alone},
                                                 {"far_lines_miss", far_lines_miss},
                                                 {"lines_hit_points", lines_hit_points},
                                                 {"signs_next_to_squares", signs_next_to_squares},
                                                 {"entries_at_whole_roots", entries_at_whole_roots}};

}  // namespace cases
