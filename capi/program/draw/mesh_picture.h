/* A picture of triangles: SVG, in painter's order. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "draw/pocket_colours.h"
#include "read/failure.h"
#include "read/molecule.h"
#include "write/mesh_file.h"

/* The number of pockets with their own colours; all others share the colour OTHER_POCKETS. */
enum { MESH_POCKETS = POCKET_COLOURS, OTHER_POCKETS = MESH_POCKETS + 1 };

/* Pockets and their colours. */
struct mesh_pockets {
  uint32_t all;                  /* how many there are */
  uint32_t count;                /* how many have their own colours, up to MESH_POCKETS */
  uint32_t number[MESH_POCKETS]; /* the numbers by which those are named */
  uint8_t *of_triangle;          /* [of_outside], the pocket of each, from 1 on, or OTHER_POCKETS; 0: none */
  uint8_t *of_patch;             /* [patches of the mesh], the same for patches around voids, which are of one pocket */
  double through[3];             /* the middle of the first one, through which a cut goes */
};

/* The view of a mesh, and what is shown. */
struct mesh_view {
  double axis[3][3]; /* to the right, upwards and towards the viewer: unit vectors */
  bool cut;          /* leave out all before the middle of the largest void, or, without voids, of everything */
  bool dark;         /* a dark page */
  const struct mesh_patch *patches;   /* of the smooth surface; else NULL */
  const struct mesh_pockets *pockets; /* or NULL */
  uint32_t of_outside;                /* the first so many triangles show only what is no void, all others only voids */
};

/* Write a picture of a closed mesh to the file `path` (output_file.h), 1000 px wide, with light from the upper left,
 * colours by element, and a legend.
 *
 * Each patch of a sphere is an area with one radial gradient. It is known where the gradient's circles are, and so no
 * triangles are visible. Saddles are cut into bands of equal light. Convex patches, where the probe touches one atom,
 * have its colour, and all patches between them share another one, so that colours meet at the borders of patches,
 * which are hairlines. Farther triangles are painted first (mesh_layers.h).
 *
 * With a cut the picture also shows the inside of the surface, its section by the plane as a line, and voids as bodies
 * in teal, which the legend tells; the outside has one colour, and crumbs are dropped (mesh_parts.h). With pockets only
 * these have colours, voids or not, and rims (mesh_lines.h); pockets without their own colour are grey. *bytes becomes
 * the number of bytes written. False, with the file named, if it cannot be written in full. */
bool mesh_picture_write(const struct triangle_mesh *mesh, const struct mesh_view *view, const struct molecule *molecule,
                        const char *title, const char *path, uint64_t *bytes, struct failure *failure);
