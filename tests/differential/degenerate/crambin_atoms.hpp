// Crambin's 327 atoms as lengths in angstrom.
#pragma once

#include <filesystem>
#include <vector>

namespace degenerate {

// Balls as the C interface takes them.
struct Molecule {
  std::vector<double> xyz;
  std::vector<double> radius;

  void add(double x, double y, double z, double r) {
    xyz.insert(xyz.end(), {x, y, z});
    radius.push_back(r);
  }
};

// The ATOM records of a PDB file of a protein without hydrogen atoms, with radii C 1.70, N 1.55, O 1.52, S 1.80.
// Throws std::runtime_error on other elements and on a file without atoms.
Molecule read_heavy_atoms(const std::filesystem::path &file);

}  // namespace degenerate
