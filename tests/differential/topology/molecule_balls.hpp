// Molecules as lattice balls: PDB files give three decimals, so a step of 0.001 angstrom loses nothing.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "molecule_files.hpp"

// Lattice steps in an angstrom.
inline constexpr int64_t steps_per_angstrom = 1000;

// Which records of a PDB file are read.
enum class Records { all, protein };

// The atoms of a PDB file, of the first model and the first alternate location, with radii C 1.70, N 1.55, O 1.52,
// S 1.80, P 1.80, H 1.10, Cu 1.40, Zn 1.39; `protein` means ATOM records alone. A name that ends in .gz is read
// through gzip. Throws std::runtime_error for elements without radius and for files without atoms.
oracle::Balls read_molecule(const std::filesystem::path &file, Records records);

// Every ball larger by a probe, in steps.
oracle::Balls grown(const oracle::Balls &balls, int64_t probe);
