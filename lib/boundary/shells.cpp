#include "boundary/shells.hpp"

namespace hsp {

void find_shells(const Boundary &boundary, BoundaryArrays &arrays, Span<uint32_t> scratch) {
  DisjointSets shells(scratch.part(0, arrays.face_count));
  shells.reset();
  for (uint32_t e = 0; e < boundary.half_edge_count(); ++e) {
    const uint32_t twin = boundary.twin(e);
    if (twin > e) shells.join(boundary.face_of(e), boundary.face_of(twin));
  }
  for (const CircleRecord &circle : arrays.circles.items()) {
    shells.join(boundary.face_of_loop(circle.loop[0]), boundary.face_of_loop(circle.loop[1]));
  }
  arrays.shell_count = 0;
  for (uint32_t face = 0; face < arrays.face_count; ++face) {
    const uint32_t representative = shells.find(face);  // the smallest face of the shell
    arrays.faces[face].shell = representative == face ? arrays.shell_count++ : arrays.faces[representative].shell;
  }
}

}  // namespace hsp
