#include "paper_molecules.hpp"

namespace bench {

Balls with_radii(const Molecule &molecule, Radii radii) {
  return {support::with_radii(molecule.atoms, radii), molecule.name};
}

std::vector<Molecule> paper_molecules() {
  const auto own = [](const std::string &name, const std::string &file) {
    return Molecule{name, support::read_atoms(support::own_molecule(file))};
  };
  return {own("caffeine", "caffeine.pdb"), own("acetyl", "acetyl_coa.pdb"), own("crambin", "crambin.pdb"),
          own("felix_model", "felix_model.pdb"), own("sod_stand_in", "sod_stand_in.pdb")};
}

}  // namespace bench
