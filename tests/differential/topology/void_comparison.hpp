// The voids of a molecule against flood fill.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "topology_run.hpp"

// Lengths in lattice steps.
//
// Which points lie in one cell is decided by the dual complex: of every certain region of a filling of the whole with
// columns of the width `coarse` one point, and `samples` further ones. Volumes are decided by flood fill: every void
// of the library is filled again in a box of its own with finer and finer columns, until the perhaps free region
// around it is closed off. Then its volume lies between those of the certain and of the perhaps free region; if no
// column is fine enough to tell several voids apart, the sum of theirs does. A void behind a wall thinner than the
// finest columns can prove has no upper bound; how many are left open like this is limited by the caller.
struct VoidSettings {
  int64_t coarse = 100;
  std::vector<int64_t> fine = {50, 20, 10, 4};
  int64_t margin = 1000;  // of the boxes around the voids
  int samples = 500;
  long double width = 0.1L;  // relative distance of the bounds of a volume that needs no finer columns
  long double large = 1e8L;  // a volume for which the finest columns must come so close
};

struct VoidFindings {
  std::string wrong;  // the first contradiction
  size_t regions = 0;
  size_t voids = 0;
  size_t bounded = 0;      // voids whose volume lies between proved bounds
  size_t told_apart = 0;   // of these, from all other voids
  long double volume = 0;  // of all voids
  long double bounded_volume = 0;
  long double widest = 0;  // largest relative distance of the bounds of a large volume
};

VoidFindings compare_voids(const oracle::Balls &balls, const VoidSettings &settings);
