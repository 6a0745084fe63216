// Large inputs out of small ones: copies of a molecule on a lattice.
#pragma once

#include <array>

#include "paper_molecules.hpp"

namespace bench {

// copies x copies x copies of the balls, named NAME_x<number of copies>. The copies are pushed together along the
// three axes until centres of different copies are about 3 Angstrom apart where they come nearest, as neighbouring
// proteins are, so that a tiling is no looser than what it is made of.
Balls tiled(const Balls &balls, int copies);

// A cubic lattice of `side` balls along each axis, with a window in every square of four: nothing is in general
// position.
Balls tied_lattice(int side);

// The distances between neighbouring copies of a tiling along the three axes: the sides of a periodic box with one
// copy.
std::array<double, 3> tiling_period(const Balls &balls);

}  // namespace bench
