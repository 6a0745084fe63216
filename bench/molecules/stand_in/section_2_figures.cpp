#include "section_2_figures.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace stand_in {

SectionTwoFigures section_2_figures(std::span<const LatticeBall> balls) {
  SectionTwoFigures figures;
  if (balls.empty()) return figures;
  figures.balls = static_cast<int64_t>(balls.size());
  figures.largest_radius = balls[0].radius;
  figures.smallest_radius = balls[0].radius;
  std::vector<int64_t> overlaps(balls.size());
  for (size_t i = 0; i < balls.size(); ++i) {
    figures.largest_radius = std::max(figures.largest_radius, balls[i].radius);
    figures.smallest_radius = std::min(figures.smallest_radius, balls[i].radius);
    for (size_t j = i + 1; j < balls.size(); ++j) {
      const Point apart = balls[j].centre - balls[i].centre;
      const int64_t square = dot(apart, apart);
      const int64_t sum = balls[i].radius + balls[j].radius;
      if (square < sum * sum) {
        ++overlaps[i];
        ++overlaps[j];
      }
      const int64_t larger = std::max(balls[i].radius, balls[j].radius);
      const bool first = figures.rho_numerator == 0 && figures.rho_denominator == 1;
      if (first || square * figures.rho_denominator < figures.rho_numerator * larger * larger) {
        figures.rho_numerator = square;
        figures.rho_denominator = larger * larger;
      }
    }
  }
  for (const int64_t count : overlaps) {
    figures.overlaps += count;
    figures.most_overlaps = std::max(figures.most_overlaps, count);
  }
  return figures;
}

}  // namespace stand_in
