// Molecules from files, and the sets of radii that their atoms can have.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ball_list.hpp"

namespace support {

struct Atom {
  std::string element;           // upper case
  std::array<double, 3> centre;  // angstrom
};

// Which records of a PDB file are read: ATOM and HETATM, or ATOM alone.
enum class Records { all, protein };

// The atoms of a .pdb file, an .xyz file, or a .cif file (of which always the ATOM records alone). If the name goes on
// with .gz the file is unpacked. Throws std::runtime_error if there are no atoms or one cannot be read.
//
// Files with several models or alternate locations are not read correctly; no test uses one.
std::vector<Atom> read_atoms(const std::filesystem::path &file, Records records = Records::all);

enum class Radii {
  paper,            // Section 2: C 1.52, Ca 3.48, H 0.70, N 1.36, O 1.28, P 2.18, S 2.10; copper and zinc 2.50
  van_der_waals,    // Bondi 1964 with H 1.10 (Rowland and Taylor 1996)
  metals_as_sulfur  // the same, but 1.80 for copper and zinc
};

// One line that says which radii these are.
std::string_view describe(Radii radii);

// In angstrom. Throws std::runtime_error for an element that the set has no radius for.
BallList with_radii(const std::vector<Atom> &atoms, Radii radii);

// A file of the project's own molecules.
std::filesystem::path own_molecule(const std::string &name);
// The names of the benchmarks' molecules, smallest first.
std::vector<const char *> bench_molecules();

// A file in the folder of further molecules, which the environment variable HSP_MOLECULES names, or else the CMake
// variable HSP_MOLECULES. Nothing if there is no such file.
std::optional<std::filesystem::path> further_molecule(const std::string &name);

}  // namespace support
