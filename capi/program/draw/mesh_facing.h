/* Where a smooth surface turns away from the viewer. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "draw/mesh_picture.h"

/* Above 0 if a triangle shows its outside, by the normals of its patch in its corners: of a sphere its own, so that two
 * that meet at an angle differ along the edge between them. */
double mesh_facing(const struct triangle_mesh *mesh, const struct mesh_view *view, const struct molecule *molecule,
                   uint32_t triangle);

/* Split all triangles that the contour of the surface goes through, along it: edges of triangles are on both sides of
 * it, and so a picture of them ends in teeth. Between two corners it is where the part of their normals to the viewer
 * would be 0 if it changed evenly, on the surface, which bulges over the edge as both normals have it. marks: as of
 * mesh_split. */
bool mesh_facing_split(struct triangle_mesh *mesh, const struct mesh_view *view, const struct molecule *molecule,
                       uint8_t **marks, struct failure *failure);
