// The molecules of the benchmarks, by name.
#pragma once

#include <string>
#include <vector>

#include "molecule_file.hpp"

namespace bench {

using support::Radii;

struct Molecule {
  std::string name;
  std::vector<support::Atom> atoms;
};

// The balls of a molecule, in Angstrom.
struct Balls : support::BallList {
  std::string name;
};

// Throws std::runtime_error that names the element that the set has no radius for.
Balls with_radii(const Molecule &molecule, Radii radii);

// The paper's five molecules: caffeine, acetyl, crambin, felix, SOD, the last two as models; see
// bench/molecules/README.md.
std::vector<Molecule> paper_molecules();

}  // namespace bench
