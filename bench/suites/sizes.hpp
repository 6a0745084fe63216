// The sets of balls of all sizes on which times are taken: molecules and tilings, van der Waals and solvent-accessible
// balls.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "paper_molecules.hpp"

namespace bench {

struct Surface {
  const char *name;
  double probe;  // Angstrom
};

constexpr Surface surfaces[] = {{"van_der_waals", 0}, {"solvent_accessible", 1.4}};

struct Size {
  std::string name;
  std::function<Balls()> balls;  // makes them, with van der Waals radii
};

// The paper's five molecules.
std::vector<Size> molecule_sizes();

// The same and tilings of the largest, up to a million balls.
std::vector<Size> all_sizes();

}  // namespace bench
