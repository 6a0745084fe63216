#include "brute_queries.hpp"

#include <algorithm>
#include <cmath>

namespace oracle {
namespace {

Int128 squared_distance(const LatticeBall &a, const LatticeBall &b) {
  const Vector difference = centre_difference(a, b);
  return dot(difference, difference);
}

Int128 squared_radius_sum(const LatticeBall &a, const LatticeBall &b) {
  const Int128 sum = Int128{a.radius} + b.radius;
  return sum * sum;
}

}  // namespace

std::vector<uint32_t> balls_meeting(const Balls &balls, const LatticeBall &query) {
  std::vector<uint32_t> hits;
  for (uint32_t i = 0; i < balls.size(); ++i)
    if (squared_distance(balls[i], query) <= squared_radius_sum(balls[i], query)) hits.push_back(i);
  return hits;
}

std::vector<uint32_t> neighbours(const Balls &balls, uint32_t ball) {
  std::vector<uint32_t> hits = balls_meeting(balls, balls[ball]);
  hits.erase(std::find(hits.begin(), hits.end(), ball));
  return hits;
}

Figures brute_figures(const Balls &balls) {
  Figures figures;
  const size_t n = balls.size();
  const auto [smallest, largest] = std::minmax_element(
      balls.begin(), balls.end(), [](const LatticeBall &a, const LatticeBall &b) { return a.radius < b.radius; });
  figures.zero_radius = n > 0 && smallest->radius == 0;
  figures.no_pair = n < 2 || largest->radius == 0;
  if (n > 0 && !figures.zero_radius)
    figures.k = static_cast<long double>(largest->radius) / static_cast<long double>(smallest->radius);

  std::vector<uint32_t> overlaps(n, 0);
  long double rho = INFINITY;
  for (size_t i = 0; i < n; ++i)
    for (size_t j = 0; j < i; ++j) {
      const Int128 distance = squared_distance(balls[i], balls[j]);
      if (distance == 0) figures.coincident = true;
      if (distance < squared_radius_sum(balls[i], balls[j])) {
        ++overlaps[i];
        ++overlaps[j];
      }
      const int64_t larger = std::max(balls[i].radius, balls[j].radius);
      if (larger > 0)
        rho = std::min(rho, std::sqrt(static_cast<long double>(distance)) / static_cast<long double>(larger));
    }
  if (!figures.no_pair && !figures.coincident) figures.rho = rho;
  for (const uint32_t count : overlaps) {
    figures.max_overlaps = std::max(figures.max_overlaps, count);
    figures.mean_overlaps += static_cast<long double>(count) / static_cast<long double>(n);
  }
  if (!figures.zero_radius && !figures.coincident && !figures.no_pair)
    figures.neighbour_bound = 216 * std::pow(figures.k / figures.rho, 3.0L);
  return figures;
}

}  // namespace oracle
