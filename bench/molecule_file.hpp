// Molecules for the benchmarks: coordinates and elements from a PDB file, radii from a named set.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ball_list.hpp"

namespace bench {

struct Molecule {
  std::string name;
  std::vector<double> xyz;            // [n][3], Angstrom
  std::vector<std::string> elements;  // [n], upper case
};

// The balls of a molecule, in Angstrom.
struct Balls : support::BallList {
  std::string name;
};

enum class Radii {
  paper,         // Section 2: C 1.52, Ca 3.48, H 0.70, N 1.36, O 1.28, P 2.18, S 2.10; copper and zinc 2.50
  van_der_waals  // Bondi 1964 with H 1.10 (Rowland and Taylor 1996)
};

// One line that says which radii these are.
std::string_view describe(Radii radii);

// Read the ATOM and HETATM records of the first model and of the first alternate location. Throws std::runtime_error
// with the file's name if it cannot be read, holds no atoms, or a coordinate is no number.
Molecule read_pdb(const std::filesystem::path &file, std::string name);

// Throws std::runtime_error that names the element that the set has no radius for.
Balls with_radii(const Molecule &molecule, Radii radii);

// The paper's five molecules: caffeine, acetyl, crambin, felix, SOD, the last two as models; see molecules/README.md.
std::vector<Molecule> paper_molecules();

// A molecule of the folder of further molecules, or nothing if the folder or the file is not there.
std::optional<Molecule> further_molecule(const std::string &file, std::string name);

}  // namespace bench
