// The critical points of the distance to a union of balls: its maxima, gates (saddles where three or more balls are
// nearest) and gaps (saddles between two balls). All sets of two, three and four balls are tried, in exact integers and
// their square roots. Which maxima a probe can get between follows from cycles of the balls' nerve. The library goes
// uphill from its gates instead.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "lattice_ball.hpp"

namespace oracle {

// The balls that are not inside another one; of equal balls the first stays.
Balls outer_balls(const Balls &balls);

// The maxima and gates of some balls, exactly, with all ties.
struct BrutePores {
  static constexpr size_t never = SIZE_MAX;
  struct Point {
    size_t level;   // the rank of the point's distance from its balls, the largest first; equal distances, equal ranks
    size_t number;  // of a maximum: its index in `meet`
  };
  // Each point under the ids of all its nearest balls, in ascending order.
  std::map<std::vector<uint32_t>, Point> gates, maxima;
  // meet[a][b]: the level of the tightest gate on the widest path between two maxima. The index behind the last maximum
  // is the outside. `never` if that gate is not above the floor.
  std::vector<std::vector<size_t>> meet;
};

// The points farther than `floor` from the balls, of which there are at most 16.
BrutePores brute_pores(const Balls &outer, int64_t floor);

// A list of pores, for example the library's, that is to be compared with BrutePores; the widest first.
struct ListedPores {
  std::vector<std::vector<uint32_t>> maxima, gates;      // the nearest balls of each, in ascending order
  std::vector<std::array<size_t, 2>> ends;               // of each gate: two maxima; the outside is behind the last one
  std::function<uint32_t(size_t, size_t)> gate_between;  // the gate where the classes of two ends meet, or no_ball
};
// The first thing that is wrong, in words; empty if there is none.
std::string first_difference(const BrutePores &expected, const ListedPores &listed);

// The number of gaps: of pairs of balls whose gap has a middle that is nearer to the two than to any other ball. In
// integers.
int count_gaps(const Balls &outer);

// The vectors of a periodic box.
using BoxRows = std::array<LatticePoint, 3>;
LatticeBall moved_by(const LatticeBall &ball, const BoxRows &box, const std::array<int, 3> &times);

// The number of gaps in a periodic box, each counted once for all its copies. Images up to `copies` boxes away in each
// direction are looked at. Differences of more than 1000 steps are decided in doubles, smaller ones in integers.
int count_gaps(const Balls &outer, const BoxRows &box, int copies);

}  // namespace oracle
