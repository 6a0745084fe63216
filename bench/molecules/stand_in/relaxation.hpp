// Letting the atoms of the stand-in find room: projection onto distances.
#pragma once

#include "chains.hpp"
#include "random_numbers.hpp"

namespace stand_in {

// Move the atoms until bonds, angles and contacts stand as chemistry wants them and every atom is in its lobe, as far
// as all of that can be had at once. Position-based dynamics (Mueller, Heidelberger, Hennix, Ratcliff 2007): in each
// sweep every pair that stands wrong is moved apart or together along its line, one pair after the other in a fixed
// order, which in integers makes the result the same everywhere.
void relax(Assembly &assembly, support::Random &random);

}  // namespace stand_in
