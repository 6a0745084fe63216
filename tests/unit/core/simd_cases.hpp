// Operations on two doubles at once, lane by lane against the same on one double; signs of zeros count.
#pragma once

#include "cases.hpp"
#include "core/simd.hpp"

namespace cases {

struct LanePair {
  double a, b;
};
constexpr LanePair lane_pairs[] = {{0.0, 1.0},     {-0.0, 2.0},           {1.5, -1.5}, {-3.0, 0.0},  {2.0, 2.0},
                                   {0x1p-1074, 7}, {-0x1p1000, 0x1p1000}, {9.0, 16.0}, {0.25, -0.0}, {-1e300, -1.0}};

inline bool same_bits(double a, double b) {
  return std::bit_cast<uint64_t>(a) == std::bit_cast<uint64_t>(b);
}

// Both orders of the lanes, so that nothing answers for its neighbour.
inline uint32_t lanes_answer_one_by_one() {
  return first_failing(lane_pairs, [](const LanePair &c) {
    for (uint32_t lane = 0; lane < 2; ++lane) {
      const double in[2] = {lane == 0 ? c.a : c.b, lane == 0 ? c.b : c.a};
      const hsp::Lanes x = hsp::load_lanes(in);
      const hsp::Lanes y = hsp::all_lanes(c.b);
      const hsp::LaneMask smaller = x < y;
      double out[2];
      hsp::store_lanes(out, x);
      int64_t words[2];
      hsp::store_mask(words, smaller);
      const hsp::LaneMask loaded = hsp::load_mask(words);
      uint32_t set = 0;
      for (uint32_t k = 0; k < 2; ++k) {
        const bool is_smaller = in[k] < c.b;
        set += is_smaller ? 1U : 0U;
        const double magnitude = in[k] < 0.0 || same_bits(in[k], -0.0) ? -in[k] : in[k];
        if (!same_bits(out[k], in[k]) || !same_bits(y[k], c.b)) return false;
        if (words[k] != (is_smaller ? -1 : 0) || loaded[k] != words[k]) return false;
        if (!same_bits(hsp::mask_and(smaller, x)[k], is_smaller ? in[k] : 0.0)) return false;
        if (!same_bits(hsp::select(smaller, x, y)[k], is_smaller ? in[k] : c.b)) return false;
        if (!same_bits(hsp::negate_if(smaller, x)[k], is_smaller ? -in[k] : in[k])) return false;
        if (!same_bits(hsp::absolute(x)[k], magnitude)) return false;
        if (!same_bits(hsp::square_root(hsp::absolute(x))[k], std::sqrt(magnitude))) return false;
        const hsp::LaneMask positive = x > hsp::all_lanes(0.0);
        if (hsp::mask_and(smaller, positive)[k] != (is_smaller && in[k] > 0.0 ? -1 : 0)) return false;
      }
      if (hsp::count(smaller) != set || hsp::any(smaller) != (set > 0)) return false;
      if (!same_bits(hsp::sum_of(x), in[0] + in[1])) return false;
    }
    return true;
  });
}

inline uint32_t vectors_of_lanes() {
  const hsp::LaneVector a{{1, 2}, {3, 5}, {7, 11}}, b{{13, 17}, {19, 23}, {29, 31}};
  const hsp::LaneVector sum = a + b, difference = a - b, twice = hsp::all_lanes(2.0) * a, n = hsp::cross(a, b);
  const hsp::LaneVector kept = hsp::mask_and(hsp::LaneMask{0, -1}, a);
  const hsp::Lanes product = hsp::dot(a, b);
  const bool conditions[] = {
      sum.x[0] == 14 && sum.y[1] == 28 && sum.z[0] == 36,
      difference.x[1] == -15 && difference.y[0] == -16 && difference.z[1] == -20,
      twice.x[1] == 4 && twice.y[0] == 6 && twice.z[1] == 22,
      product[0] == 13 + 57 + 203 && product[1] == 34 + 115 + 341,
      n.x[0] == 3 * 29 - 7 * 19 && n.y[0] == 7 * 13 - 1 * 29 && n.z[0] == 1 * 19 - 3 * 13,
      n.x[1] == 5 * 31 - 11 * 23 && n.y[1] == 11 * 17 - 2 * 31 && n.z[1] == 2 * 23 - 5 * 17,
      kept.x[0] == 0 && kept.y[0] == 0 && kept.z[0] == 0 && kept.x[1] == 2 && kept.y[1] == 5 && kept.z[1] == 11};
  return first_false(conditions);
}

inline constexpr Check core_simd[] = {{"lanes_answer_one_by_one", lanes_answer_one_by_one},
                                      {"vectors_of_lanes", vectors_of_lanes}};

}  // namespace cases
