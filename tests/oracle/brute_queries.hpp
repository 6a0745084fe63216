// The queries of Section 3 and the figures of Section 2 of the paper by looking at every ball and every pair: no grid,
// and integers of any size.
#pragma once

#include <cstdint>
#include <vector>

#include "lattice_ball.hpp"

namespace oracle {

// The balls that meet a closed ball (a point if its radius is 0), ascending. Coordinates up to 2^51, radii up to 2^51.
std::vector<uint32_t> balls_meeting(const Balls &balls, const LatticeBall &query);

// The other balls that meet ball `ball`, ascending.
std::vector<uint32_t> neighbours(const Balls &balls, uint32_t ball);

// Whether a ray enters the first ball before (-1), together with (0) or behind (1) the second one. The ray must start
// outside both balls and meet both. Any 64-bit numbers.
int compare_entries(const LatticeBall &first, const LatticeBall &second, const LatticePoint &origin,
                    const LatticePoint &direction);

// The closed ball with the least t >= 0 for which it contains origin + t direction, of several the one with the lowest
// number; no_ball if there is none.
uint32_t first_on_ray(const Balls &balls, const LatticePoint &origin, const LatticePoint &direction);

// The figures of Section 2. Numbers that are not defined are 0 and named by a flag.
struct Figures {
  long double k = 0;                // largest radius / smallest radius
  long double rho = 0;              // min over pairs of distance / larger radius
  long double mean_overlaps = 0;    // mean number of others at a distance below the sum of the radii
  long double neighbour_bound = 0;  // 216 (k / rho)^3
  uint32_t max_overlaps = 0;
  bool zero_radius = false;  // k is not defined
  bool coincident = false;   // rho is 0
  bool no_pair = false;      // rho is not defined
};
Figures brute_figures(const Balls &balls);

}  // namespace oracle
