#include "boundary/shells.hpp"

namespace hsp {

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
