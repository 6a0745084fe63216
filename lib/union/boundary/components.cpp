#include "boundary/components.hpp"

namespace hsp {

void number_components(const CubeGrid &grid, Patience &patience, BoundaryArrays &arrays) {
  const BallSet &balls = grid.balls();
  const Span<uint32_t> lowest =
      arrays.component;  // first used for: at each representative, the ball of lowest rank of its set so far
  DisjointSets components(arrays.component_origin.part(0, arrays.balls));
  components.flatten();
  for (uint32_t i = 0; i < arrays.balls; ++i) {
    const uint32_t representative = arrays.component_origin[i];
    if (representative == i || balls.ranks_before(i, lowest[representative])) lowest[representative] = i;
  }
  for (uint32_t i = 0; i < arrays.balls; ++i) arrays.component_origin[i] = lowest[arrays.component_origin[i]];
  if (!patience.allows(50 * uint64_t{arrays.balls})) return;
  for (uint32_t i = 0; i < arrays.balls; ++i) arrays.component[i] = no_id;
  arrays.component_count = 0;
  for (uint32_t input = 0; input < arrays.balls; ++input) {
    const uint32_t i = grid.grid_index(input);
    // A component's number is stored first at its origin.
    uint32_t &number = arrays.component[arrays.component_origin[i]];
    if (number == no_id) number = arrays.component_count++;
    arrays.component[i] = number;
  }
}

void find_shells(const Boundary &boundary, BoundaryArrays &arrays, Span<uint32_t> scratch, Patience &patience) {
  DisjointSets shells(scratch.part(0, arrays.face_count));
  shells.reset();
  join_faces(boundary, {0, boundary.vertex_count()}, {0, boundary.circle_count()}, patience, shells);
  if (!patience.allows(100 * uint64_t{arrays.face_count})) return;
  number_shells(shells, arrays);
}

void number_shells(DisjointSets shells, BoundaryArrays &arrays) {
  arrays.shell_count = 0;
  for (uint32_t face = 0; face < arrays.face_count; ++face) {
    const uint32_t representative = shells.find(face);  // the smallest face of the shell
    arrays.faces[face].shell = representative == face ? arrays.shell_count++ : arrays.faces[representative].shell;
  }
}

}  // namespace hsp
