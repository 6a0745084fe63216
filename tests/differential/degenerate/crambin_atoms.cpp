#include "crambin_atoms.hpp"

#include "molecule_files.hpp"

namespace degenerate {

Molecule crambin_atoms() {
  Molecule molecule;
  for (const Atom &atom : read_atoms(own_molecule("crambin.pdb")))
    molecule.add(atom.centre[0], atom.centre[1], atom.centre[2], radius_of(atom.element));
  return molecule;
}

}  // namespace degenerate
