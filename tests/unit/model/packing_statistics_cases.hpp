// The statistics of small sets as they follow from the distances by hand, and of random sets from all pairs.
#pragma once

#include "model/packing_statistics.hpp"
#include "small_grid.hpp"

namespace cases {

struct Packed {
  uint32_t n;
  LatticePoint ball[4];
  double k, rho, mean_overlaps;
  uint32_t max_overlaps;
  bool zero_radius, coincident, no_pair;
  double neighbour_bound;
};
constexpr Packed packed[] = {
    {0, {}, 0, 0, 0, 0, false, false, true, 0},
    {1, {{1, 2, 3, 5}}, 1, 0, 0, 0, false, false, true, 0},
    {1, {{1, 2, 3, 0}}, 0, 0, 0, 0, true, false, true, 0},
    {2, {{0, 0, 0, 2}, {8, 0, 0, 4}}, 2, 2, 0, 0, false, false, false, 216},
    {2, {{0, 0, 0, 2}, {0, 6, 0, 4}}, 2, 1.5, 0, 0, false, false, false, 512},  // balls that touch do not overlap
    {2, {{0, 0, 0, 2}, {3, 0, 4, 3}}, 1.5, 5.0 / 3, 0, 0, false, false, false, 157.464},
    {2, {{0, 0, 0, 2}, {0, 0, 5, 4}}, 2, 1.25, 1, 1, false, false, false, 216 * 4.096},
    {2, {{0, 0, 0, 3}, {0, 0, 0, 4}}, 4.0 / 3, 0, 1, 1, false, true, false, 0},
    {2, {{0, 0, 0, 0}, {0, 0, 9, 4}}, 0, 2.25, 0, 0, true, false, false, 0},
    {2, {{0, 0, 0, 0}, {5, 0, 0, 0}}, 0, 0, 0, 0, true, false, true, 0},
    {2, {{0, 0, 0, 0}, {0, 0, 0, 0}}, 0, 0, 0, 0, true, true, true, 0},
    {3, {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 9, 4}}, 0, 0, 0, 0, true, true, false, 0},
    // A hub and its leaves: three overlaps, and one each.
    {4, {{0, 0, 0, 5}, {9, 0, 0, 5}, {-9, 0, 0, 5}, {0, 9, 0, 5}}, 1, 1.8, 1.5, 3, false, false, false, 216 / 5.832},
    // The closest pair is not the one with the smallest ratio.
    {4, {{0, 0, 0, 10}, {12, 0, 0, 10}, {0, 50, 0, 1}, {2, 50, 0, 1}}, 10, 1.2, 0.5, 1, false, false, false, 125000},
    // Far beyond neighbouring cubes, at the ends of the lattice too.
    {2, {{0, 0, 0, 1}, {3000000, 4000000, 0, 1}}, 1, 5e6, 0, 0, false, false, false, 216 / 125e18},
    {2,
     {{-(INT64_C(1) << 50), 0, 0, 1}, {INT64_C(1) << 50, 0, 0, 2}},
     2,
     0x1p50,
     0,
     0,
     false,
     false,
     false,
     216 * 0x1p-147}};

inline bool near_relatively(double a, double b) {
  return near(a, b, 1e-14 * (b > 0 ? b : 1));
}

inline uint32_t statistics_by_hand() {
  return first_failing(packed, [](const Packed &c) {
    if (!small_grid().build(c.ball, c.n)) return false;
    const hsp::PackingStatistics found = hsp::packing_statistics(small_grid().grid());
    return near_relatively(found.k, c.k) && near_relatively(found.rho, c.rho) &&
           near_relatively(found.mean_overlaps, c.mean_overlaps) && found.max_overlaps == c.max_overlaps &&
           found.zero_radius == c.zero_radius && found.coincident == c.coincident && found.no_pair == c.no_pair &&
           near_relatively(found.neighbour_bound(), c.neighbour_bound);
  });
}

// Dense and ever looser sets, so that the closest pair is in a cube, in neighbouring ones, or cubes apart; and balls
// near the points of a lattice, where it is among many of one coarse cube.
inline uint32_t statistics_of_all_pairs() {
  Random random(1);
  for (uint32_t round = 0; round < 240; ++round) {
    LatticePoint balls[24];
    const uint32_t n = 2 + random.below(23);
    const int64_t width = INT64_C(30) << (round % 30);
    for (uint32_t i = 0; i < n; ++i) {
      balls[i] = {random.in(-width, width), random.in(-width, width), random.in(-width, width), random.in(1, 20)};
      if (round < 120) continue;
      balls[i] = {balls[i].x / 5 + i % 2 * width, balls[i].y / 5 + i / 2 % 3 * width, balls[i].z / 5 + i / 6 * width,
                  balls[i].r};
    }
    uint32_t overlaps = 0, most = 0;
    double rho = 1e300;
    for (uint32_t i = 0; i < n; ++i) {
      uint32_t own = 0;
      for (uint32_t j = 0; j < n; ++j) {
        if (j == i) continue;
        const LatticePoint &a = balls[i], &b = balls[j];
        const double dx = static_cast<double>(a.x - b.x), dy = static_cast<double>(a.y - b.y),
                     dz = static_cast<double>(a.z - b.z);
        const double square = dx * dx + dy * dy + dz * dz;
        const int64_t sum = a.r + b.r;
        own += square < static_cast<double>(sum * sum) ? 1U : 0U;
        const double ratio = std::sqrt(square) / static_cast<double>(a.r > b.r ? a.r : b.r);
        if (ratio < rho) rho = ratio;
      }
      overlaps += own;
      if (own > most) most = own;
    }
    if (!small_grid().build(balls, n)) return round;
    const hsp::PackingStatistics found = hsp::packing_statistics(small_grid().grid());
    if (found.no_pair || found.coincident != (rho == 0.0) || !near_relatively(found.rho, rho)) return round;
    if (found.max_overlaps != most || !near_relatively(found.mean_overlaps, static_cast<double>(overlaps) / n))
      return round;
  }
  return all_hold;
}

// A set for which coarser cubes are tried: its directory of rows, whose memory they take, is there afterwards.
inline uint32_t rows_are_kept() {
  const LatticePoint balls[] = {{1, 1, 1, 1}, {5, 1, 1, 1}};
  if (!small_grid().build(balls, 2)) return 0;
  hsp::CubeGrid &grid = small_grid().grid();
  for (uint32_t asked = 0; asked < 2; ++asked) {
    hsp::BallRange rows[2];
    if (!grid.rows().is_there() || grid.rows().find({0, 0, 0}, {2, 0, 0}, {rows, 2}) != 1) return 1 + asked;
    if (rows[0].first != 0 || rows[0].last != 2) return 1 + asked;
    if (!near(hsp::packing_statistics(grid).rho, 4.0, 1e-12)) return 3;
  }
  return all_hold;
}

inline constexpr Check model_packing_statistics[] = {{"statistics_by_hand", statistics_by_hand},
                                                     {"statistics_of_all_pairs", statistics_of_all_pairs},
                                                     {"rows_are_kept", rows_are_kept}};

}  // namespace cases
