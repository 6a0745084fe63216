// Maxima, gates and gaps of the distance to some balls by trying all sets of two, three and four: slow, and another way
// than that of the library.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "lattice_ball.hpp"

namespace oracle {

// Without balls inside others; of equal ones the first stays.
Balls outer_balls(const Balls &balls);

// All of it in integers and their square roots, whatever ties.
struct BrutePores {
  static constexpr size_t never = SIZE_MAX;
  struct Point {
    size_t level;   // a rank, the highest level first; equal levels have equal ranks
    size_t number;  // of a maximum
  };
  // By all nearest balls, in ascending order.
  std::map<std::vector<uint32_t>, Point> gates, maxima;
  // For two maxima, or one and the outside behind the last one, the level of the tightest gate on the widest path
  // between them; never if that is not above the floor.
  std::vector<std::vector<size_t>> meet;
};

// Of up to 16 balls, points above a floor.
BrutePores brute_pores(const Balls &outer, int64_t floor);

// Pores that are to be held against that, the widest first.
struct ListedPores {
  std::vector<std::vector<uint32_t>> maxima, gates;      // the nearest balls of each, in ascending order
  std::vector<std::array<size_t, 2>> ends;               // of gates: maxima, or the outside behind the last one
  std::function<uint32_t(size_t, size_t)> gate_between;  // where the classes of two of these meet; no_ball for nowhere
};
// The first thing that is wrong, in words; empty if there is none.
std::string first_difference(const BrutePores &expected, const ListedPores &listed);

// How many pairs have the middle of their gap nearer than any other ball: the third kind of critical points. In
// integers.
int count_gaps(const Balls &outer);

// The vectors of a periodic box.
using BoxRows = std::array<LatticePoint, 3>;
LatticeBall moved_by(const LatticeBall &ball, const BoxRows &box, const std::array<int, 3> &times);

// The gaps of balls in a box, each once for all its copies. Images up to `copies` boxes away count in each direction.
int count_gaps(const Balls &outer, const BoxRows &box, int copies);

}  // namespace oracle
