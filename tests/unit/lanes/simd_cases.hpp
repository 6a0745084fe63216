// Operations on two doubles at once, lane by lane against the same on one double.
#pragma once

#include "cases.hpp"
#include "lanes/simd.hpp"

namespace cases {

struct LanePair {
  double a, b;
};
constexpr LanePair lane_pairs[] = {{0.0, 1.0},     {-0.0, 2.0},           {1.5, -1.5}, {-3.0, 0.0},  {2.0, 2.0},
                                   {0x1p-1074, 7}, {-0x1p1000, 0x1p1000}, {9.0, 16.0}, {0.25, -0.0}, {-1e300, -1.0}};

// Both orders of the lanes, so that nothing answers for its neighbour.
inline uint32_t lanes_answer_one_by_one() {
  return first_failing(lane_pairs, [](const LanePair &c) {
    for (uint32_t lane = 0; lane < 2; ++lane) {
      const double in[2] = {lane == 0 ? c.a : c.b, lane == 0 ? c.b : c.a};
      const hsp::Lanes x = hsp::load_lanes(in);
      const hsp::Lanes y = hsp::all_lanes(c.b);
      const hsp::LaneMask smaller = x < y;
      uint32_t set = 0;
      for (uint32_t k = 0; k < 2; ++k) {
        if (x[k] != in[k] || y[k] != c.b || smaller[k] != (in[k] < c.b ? -1 : 0)) return false;
        set += in[k] < c.b ? 1U : 0U;
      }
      if (hsp::count(smaller) != set || hsp::any(smaller) != (set > 0)) return false;
    }
    return true;
  });
}

inline constexpr Check lanes_simd[] = {{"lanes_answer_one_by_one", lanes_answer_one_by_one}};

}  // namespace cases
