// Two balls at a varied distance, by the library.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

// Radii and distances are whole numbers of this unit in angstrom: every bond length that is a multiple of 7 units is
// exact in the direction (2, 3, 6) / 7, and so is every radius here.
inline constexpr int64_t units_per_angstrom = 70'000'000;

// So many units make the shortest exact change of a bond length.
inline constexpr int64_t shortest_change = 7;

// Two radii with the probe added.
struct PairOfBalls {
  const char *name;
  std::array<int64_t, 2> radius;

  [[nodiscard]] int64_t touching() const { return radius[0] + radius[1]; }
  [[nodiscard]] int64_t touching_from_inside() const {
    return radius[0] > radius[1] ? radius[0] - radius[1] : radius[1] - radius[0];
  }
};

// Oxygen 1.52 and hydrogen 1.10 angstrom: the bonds O-O and O-H, without a probe and with one of 1.4 angstrom.
std::vector<PairOfBalls> scanned_pairs();

// The library's answers about a pair, in units and their powers. The first ball stays at the origin.
struct PairResults {
  std::array<double, 2> area;
  double volume;
  std::array<double, 2> area_by_distance;  // of the two areas, from their rows
  double total_by_distance;                // of the total area, from the gradient
  double volume_by_distance;
  std::array<uint32_t, 2> flags;
};

// The derivatives by the bond length are those by the second centre along (2, 3, 6) / 7.
PairResults pair_at(const PairOfBalls &pair, int64_t distance, uint32_t tangency);

double in_angstrom(double length);
double in_square_angstrom(double area);
