// Molecules from files, as balls on the integer lattice.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lattice_ball.hpp"

struct Atom {
  std::string element;
  std::array<double, 3> centre;  // angstrom
};

// The lines of a file, unpacked if its name ends in .gz. Throws std::runtime_error if it cannot be read.
std::vector<std::string> lines_of(const std::filesystem::path &file);

// C 1.70, N 1.55, O 1.52, S and P 1.80, H 1.10, others 1.80 angstrom.
double radius_of(const std::string &element);

// All atoms of a .pdb file (ATOM and HETATM records), an .xyz file, or a .cif file (ATOM records), each of which may
// be compressed and then ends in .gz. Throws std::runtime_error if there are none or one cannot be read.
std::vector<Atom> read_atoms(const std::filesystem::path &file);

// The radii are those of radius_of, plus the probe. Centres and radii, in angstrom, become the nearest multiples of 1 /
// units_per_angstrom.
oracle::Balls balls_of_atoms(const std::vector<Atom> &atoms, double probe, double units_per_angstrom);

// A file of the project's own molecules.
std::filesystem::path own_molecule(const std::string &name);

// A file of the folder of further molecules: the environment variable HSP_MOLECULES or else the CMake
// variable of this name gives it. Nothing if it is not there.
std::optional<std::filesystem::path> further_molecule(const std::string &name);
