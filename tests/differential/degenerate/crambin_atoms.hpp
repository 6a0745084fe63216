// Crambin's 327 atoms as lengths in angstrom.
#pragma once

#include <filesystem>

#include "ball_list.hpp"

namespace degenerate {

using Molecule = support::BallList;

// The ATOM records of a PDB file of a protein without hydrogen atoms, with radii C 1.70, N 1.55, O 1.52, S 1.80.
// Throws std::runtime_error on other elements and on a file without atoms.
Molecule read_heavy_atoms(const std::filesystem::path &file);

}  // namespace degenerate
