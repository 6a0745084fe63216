#include "boundary/shells.hpp"

#include "boundary/half_edge_links.hpp"

namespace hsp {

void gather_shells(BoundaryStructure &boundary) {
  const DisjointSets shells(boundary.face_parent.part(0, boundary.face_count));
  shells.reset();
  for (uint32_t use = 0; use < 3 * boundary.vertices.size(); ++use) {
    const uint32_t twin = twin_use(boundary, use);
    if (twin < use) continue;
    shells.join(boundary.loop_face[boundary.uses[use].loop], boundary.loop_face[boundary.uses[twin].loop]);
  }
  for (const CircleRecord &circle : boundary.circles.items()) {
    shells.join(boundary.loop_face[circle.loop[0]], boundary.loop_face[circle.loop[1]]);
  }
  boundary.shell_count = 0;
  for (uint32_t face = 0; face < boundary.face_count; ++face) {
    const uint32_t representative = shells.find(face);  // the smallest face of the shell
    boundary.faces[face].shell = representative == face ? boundary.shell_count++ : boundary.faces[representative].shell;
  }
}

}  // namespace hsp
