// Molecules as lattice balls.
#pragma once

#include <cstdint>
#include <filesystem>

#include "lattice_ball.hpp"
#include "molecule_file.hpp"

// Centres, and radii plus a probe, as the nearest multiples of a step.
oracle::Balls on_lattice(const support::BallList &balls, double probe, double steps_per_unit);

// In files lengths have three decimals and radii two: such a step loses nothing.
inline constexpr int64_t steps_per_angstrom = 1000;

// The atoms of a file with van der Waals radii, in these steps.
oracle::Balls read_molecule(const std::filesystem::path &file, support::Records records = support::Records::all);
