/* The border where a smooth surface turns away from the viewer. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "draw/mesh_picture.h"

/* Above 0 if a triangle shows its outside, by the normals at its corners. The normals are those of the triangle's own
 * sphere, so that two spheres that meet at an angle may differ along the edge between them. */
double mesh_facing(const struct triangle_mesh *mesh, const struct mesh_view *view, const struct molecule *molecule,
                   uint32_t triangle);

/* Split all triangles that the contour of the surface crosses, along the contour: without that a picture of them ends
 * in teeth, as their edges are on both sides of it. Between two corners the contour is where the normals' component
 * towards the viewer is 0, if it changes linearly along the edge; the new corner is not on the edge, but on the
 * surface, which bulges over the edge as both normals tell. marks: as in mesh_split. */
bool mesh_facing_split(struct triangle_mesh *mesh, const struct mesh_view *view, const struct molecule *molecule,
                       uint8_t **marks, struct failure *failure);
