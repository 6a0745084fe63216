// The paper's Section 2 figures of balls on the milliangstrom lattice, from their definitions, over all pairs.
#pragma once

#include <cstdint>
#include <span>

#include "integer_geometry.hpp"

namespace stand_in {

struct LatticeBall {
  Point centre;        // milliangstrom
  int64_t radius = 0;  // milliangstrom
};

// rho^2 = rho_numerator / rho_denominator, k = largest_radius / smallest_radius, mean = overlaps / balls: all exact.
struct SectionTwoFigures {
  int64_t largest_radius = 0;
  int64_t smallest_radius = 0;
  int64_t rho_numerator = 0;
  int64_t rho_denominator = 1;
  int64_t overlaps = 0;
  int64_t most_overlaps = 0;
  int64_t balls = 0;
};

SectionTwoFigures section_2_figures(std::span<const LatticeBall> balls);

// A quotient of integers, rounded half up, in thousandths.
constexpr int64_t thousandths(int64_t numerator, int64_t denominator) {
  return (2000 * numerator + denominator) / (2 * denominator);
}

}  // namespace stand_in
