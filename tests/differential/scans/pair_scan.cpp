#include "pair_scan.hpp"

#include <stdexcept>

#include "library_derivatives.hpp"

namespace {

constexpr std::array<int64_t, 3> direction = {2, 3, 6};

double along_direction(const double *derivative) {
  double sum = 0;
  for (size_t k = 0; k < 3; ++k) sum += derivative[k] * static_cast<double>(direction[k]) / 7;
  return sum;
}

}  // namespace

std::vector<PairOfBalls> scanned_pairs() {
  constexpr int64_t hundredth = units_per_angstrom / 100;
  constexpr int64_t oxygen = 152 * hundredth;
  constexpr int64_t hydrogen = 110 * hundredth;
  constexpr int64_t probe = 140 * hundredth;
  return {{"O-O", {oxygen, oxygen}},
          {"O-O, probe 1.4", {oxygen + probe, oxygen + probe}},
          {"O-H", {oxygen, hydrogen}},
          {"O-H, probe 1.4", {oxygen + probe, hydrogen + probe}}};
}

PairResults pair_at(const PairOfBalls &pair, int64_t distance, uint32_t tangency) {
  if (distance % shortest_change != 0) throw std::invalid_argument("no exact distance");
  const int64_t times = distance / shortest_change;
  const LibraryBoundary boundary(
      {{0, 0, 0, pair.radius[0]}, {times * direction[0], times * direction[1], times * direction[2], pair.radius[1]}});
  PairResults results{};
  const LibraryBoundary::Measures measures = boundary.measure();
  results.volume = measures.totals.volume;
  for (uint32_t i = 0; i < 2; ++i) {
    results.area[i] = measures.area[i];
    for (const hsp_area_derivative &entry : area_row(boundary, i, tangency))
      if (entry.ball == 1) results.area_by_distance[i] = along_direction(entry.centre);
  }
  const LibraryGradient of_area = gradient(boundary, {1, 0, {}, tangency});
  const LibraryGradient of_volume = gradient(boundary, {0, 1, {}, tangency});
  results.total_by_distance = along_direction(of_area.by_ball[1].data());
  results.volume_by_distance = along_direction(of_volume.by_ball[1].data());
  results.flags = {of_area.flags[0], of_area.flags[1]};
  return results;
}

double in_angstrom(double length) {
  return length / static_cast<double>(units_per_angstrom);
}
double in_square_angstrom(double area) {
  return in_angstrom(in_angstrom(area));
}
