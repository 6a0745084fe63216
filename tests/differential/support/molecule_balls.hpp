// Molecules as lattice balls.
#pragma once

#include <cstdint>
#include <filesystem>

#include "lattice_ball.hpp"
#include "molecule_file.hpp"

// Coordinates in files have three decimals and radii two: this step loses nothing.
inline constexpr int64_t steps_per_angstrom = 1000;

// The atoms of a file with van der Waals radii, in these steps.
oracle::Balls read_molecule(const std::filesystem::path &file, support::Records records = support::Records::all);
