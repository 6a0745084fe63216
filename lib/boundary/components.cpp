#include "boundary/components.hpp"

namespace hsp {

void number_components(const CubeGrid &grid, BoundaryArrays &arrays) {
  for (uint32_t i = 0; i < arrays.balls; ++i) arrays.component[i] = no_id;
  arrays.component_count = 0;
  for (uint32_t input = 0; input < arrays.balls; ++input) {
    const uint32_t i = grid.grid_index(input);
    // A component's number is stored first at its representative.
    uint32_t &number = arrays.component[arrays.components.find(i)];
    if (number == no_id) number = arrays.component_count++;
    arrays.component[i] = number;
  }
}

}  // namespace hsp
