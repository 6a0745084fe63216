#include "box_lattice.hpp"

#include <sstream>

#include "point_lattices.hpp"

namespace degenerate {

std::string name_of(const BoxLattice &lattice) {
  const auto text_of = [](const std::array<int64_t, 3> &three) {
    std::ostringstream text;
    text << three[0] << "x" << three[1] << "x" << three[2];
    return text.str();
  };
  std::ostringstream name;
  name << (lattice.slanted ? "slanted lattice " : "lattice ") << text_of(lattice.counts) << ", cell "
       << text_of(lattice.sides) << ", radius " << lattice.radius;
  return name.str();
}

oracle::Balls balls_of(const BoxLattice &lattice) {
  const auto make = lattice.slanted ? oracle::slanted_lattice : oracle::box_lattice;
  return make(lattice.counts, lattice.sides, lattice.radius);
}

Topology topology_of(const BoxLattice &lattice) {
  const int64_t diameter2 = 4 * lattice.radius * lattice.radius;
  int64_t euler = 0;
  bool all_rectangles = true;
  bool boxes = true;
  Topology topology{1, 0, 0, 0};
  // The cells that span a subset of the three directions.
  for (unsigned span = 0; span < 8; ++span) {
    int64_t diagonal2 = 0;
    int64_t cells = 1;
    int dimension = 0;
    for (size_t k = 0; k < 3; ++k) {
      const bool along = (span >> k & 1U) != 0;
      const int64_t side = lattice.sides[k] * (lattice.slanted ? 7 : 1);
      cells *= along ? lattice.counts[k] - 1 : lattice.counts[k];
      diagonal2 += along ? side * side : 0;
      dimension += along ? 1 : 0;
    }
    const bool closed = diagonal2 <= diameter2;
    if (closed) euler += dimension % 2 == 0 ? cells : -cells;
    if (dimension == 1 && !closed)
      for (size_t k = 0; k < 3; ++k) topology.components *= (span >> k & 1U) != 0 ? lattice.counts[k] : 1;
    if (dimension == 2) all_rectangles = all_rectangles && closed;
    if (dimension == 3) {
      boxes = closed;
      topology.voids = cells;
    }
  }
  if (boxes || !all_rectangles) topology.voids = 0;
  topology.shells = topology.components + topology.voids;
  topology.euler = 2 * euler;  // the boundary of a solid has twice its Euler characteristic
  return topology;
}

}  // namespace degenerate
