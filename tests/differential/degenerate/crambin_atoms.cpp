#include "crambin_atoms.hpp"

#include <fstream>
#include <stdexcept>
#include <string>

namespace degenerate {
namespace {

double radius_of(const std::string &element) {
  if (element == " C") return 1.70;
  if (element == " N") return 1.55;
  if (element == " O") return 1.52;
  if (element == " S") return 1.80;
  throw std::runtime_error("no radius for element" + element);
}

}  // namespace

Molecule read_heavy_atoms(const std::filesystem::path &file) {
  std::ifstream input(file);
  Molecule molecule;
  // Columns 31 to 54 hold the coordinates, 77 and 78 the element.
  for (std::string line; std::getline(input, line);)
    if (line.starts_with("ATOM  ") && line.size() >= 78)
      molecule.add(std::stod(line.substr(30, 8)), std::stod(line.substr(38, 8)), std::stod(line.substr(46, 8)),
                   radius_of(line.substr(76, 2)));
  if (molecule.radius.empty()) throw std::runtime_error("no atoms in " + file.string());
  return molecule;
}

}  // namespace degenerate
