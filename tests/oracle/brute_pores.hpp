// Maxima, gates and gaps of the distance to some balls by trying all sets of two, three and four: slow, and another way
// than that of the library.
#pragma once

#include <array>
#include <set>

#include "lattice_ball.hpp"

namespace oracle {

// Without balls inside others; of equal ones the first stays.
Balls outer_balls(const Balls &balls);

struct CriticalSets {
  std::set<std::array<uint32_t, 3>> gates;
  std::set<std::array<uint32_t, 4>> maxima;
  bool decided = true;  // no sign was nearer to 0 than long doubles can tell
};

// By linear equations and both roots of the quadratic, in long doubles; for sets in general position.
CriticalSets critical_sets(const Balls &outer);

// How many pairs have the middle of their gap nearer than any other ball: the third kind of critical points. In
// integers.
int count_gaps(const Balls &outer);

// The vectors of a periodic box.
using BoxRows = std::array<LatticePoint, 3>;
LatticeBall moved_by(const LatticeBall &ball, const BoxRows &box, const std::array<int, 3> &times);

// The gaps of balls in a box, each once for all its copies. Images up to `copies` boxes away count in each direction.
int count_gaps(const Balls &outer, const BoxRows &box, int copies);

}  // namespace oracle
