/* Triangles as a picture: SVG, in painter's order. */
#ifndef HARDSPHERE_TOOL_MESH_PICTURE_H
#define HARDSPHERE_TOOL_MESH_PICTURE_H

#include <stdbool.h>
#include <stdint.h>

#include "read/failure.h"
#include "read/molecule.h"
#include "write/mesh_file.h"

/* How a mesh is looked at. */
struct mesh_view {
  double axis[3][3]; /* to the right, upwards and towards the viewer: unit vectors */
  bool cut;          /* what lies before the middle of the largest void, or else of everything, is left out */
};

/* Write what is seen of a closed mesh to the file `path` (output_file.h), 1000 px wide: light from the upper left,
 * colours by element, and farther triangles first by the depth of their middles, which is right but where a triangle
 * is as large as the gap to what it covers. With a cut the inside of the surface and the rim of the cut are seen, too,
 * and voids, as bodies in red. *bytes becomes how many were written. False, with the file named, if it cannot be
 * written in full. */
bool mesh_picture_write(const struct triangle_mesh *mesh, const struct mesh_view *view, const struct molecule *molecule,
                        const char *title, const char *path, uint64_t *bytes, struct failure *failure);

#endif
