#include "boundary/shells.hpp"

namespace hsp {

void find_shells(const Boundary &boundary, BoundaryArrays &arrays, Span<uint32_t> scratch) {
  DisjointSets shells(scratch.part(0, arrays.face_count));
  shells.reset();
  // The three faces at a vertex share arcs, and every arc has a vertex.
  for (uint32_t v = 0; v < boundary.vertex_count(); ++v) {
    const uint32_t first = boundary.face_of(boundary.half_edge_at(v, 0));
    shells.join(first, boundary.face_of(boundary.half_edge_at(v, 1)));
    shells.join(first, boundary.face_of(boundary.half_edge_at(v, 2)));
  }
  for (const CircleRecord &circle : arrays.circles.items()) {
    shells.join(boundary.face_of_loop(circle.loop[0]), boundary.face_of_loop(circle.loop[1]));
  }
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
