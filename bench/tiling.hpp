// Large inputs out of small ones: copies of a molecule on a lattice.
#pragma once

#include "paper_molecules.hpp"

namespace bench {

// copies x copies x copies of the balls, named NAME_x<number of copies>. The copies are pushed together along the
// three axes until centres of different copies are about 3 Angstrom apart where they come nearest, as neighbouring
// proteins are, so that a tiling is no looser than what it is made of.
Balls tiled(const Balls &balls, int copies);

}  // namespace bench
