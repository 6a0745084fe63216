/* Triangles as a picture: SVG, in painter's order. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "draw/pocket_colours.h"
#include "read/failure.h"
#include "read/molecule.h"
#include "write/mesh_file.h"

/* The others have one colour for all. */
enum { MESH_POCKETS = POCKET_COLOURS, OTHER_POCKETS = MESH_POCKETS + 1 };

/* Pockets, each of a colour. */
struct mesh_pockets {
  uint32_t all;                  /* with those that have none of their own */
  uint32_t count;                /* up to MESH_POCKETS */
  uint32_t number[MESH_POCKETS]; /* their names */
  uint8_t *of_triangle;          /* [of_outside], which of them, from 1 on, or OTHER_POCKETS; 0: none */
  uint8_t *of_patch;             /* [patches of the mesh], the same of patches around voids, which have one answer */
  double through[3];             /* the middle of the first, where a cut goes through */
};

/* How a mesh is looked at. */
struct mesh_view {
  double axis[3][3]; /* to the right, upwards and towards the viewer: unit vectors */
  bool cut;          /* what lies before the middle of the largest void, or else of everything, is left out */
  bool dark;         /* the page */
  const struct mesh_patch *patches;   /* of the smooth surface; else NULL */
  const struct mesh_pockets *pockets; /* or NULL */
  uint32_t of_outside; /* triangles: only the first so many show what is no void, only the others voids */
};

/* Write what is seen of a closed mesh to the file `path` (output_file.h), 1000 px wide, with light from the upper left
 * and colours by element, with a legend.
 *
 * Patches of spheres are areas with one radial gradient each: as it is known which circles of it are where, no triangle
 * is seen. Saddles are cut into bands of equal light. Convex patches, where the probe touches one atom, have its
 * colour, and all between them one of their own, so that colours meet at the borders of patches, which are hairlines.
 * Farther triangles are painted first (mesh_layers.h).
 *
 * With a cut the inside of the surface is seen, too, and the section by the plane as a line, and voids as bodies in
 * teal, which the legend says; the outside has one colour, and crumbs are dropped (mesh_parts.h). With pockets these
 * alone have colours, voids or not, with rims (mesh_lines.h), and those without a colour of their own are grey. *bytes
 * becomes how many were written. False, with the file named, if it cannot be written in full. */
bool mesh_picture_write(const struct triangle_mesh *mesh, const struct mesh_view *view, const struct molecule *molecule,
                        const char *title, const char *path, uint64_t *bytes, struct failure *failure);
