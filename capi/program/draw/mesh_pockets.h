/* Pockets as a picture of the surface shows them. */
#pragma once

#include <stdbool.h>

#include "draw/mesh_picture.h"
#include "read/failure.h"
#include "read/geometry.h"
#include "write/mesh_file.h"

/* Find the pockets where the probe of the mesh fits and one of radius `wide` does not get to from outside, the widest
 * first: those that are wider than their mouths by `least`, with their numbers among all, from 1 on. A point of the
 * surface is of a pocket if a probe that touches it there finds its way up to a maximum of that; triangles are split
 * where this changes. of_triangle and of_patch are to be freed on true and on false. */
bool mesh_pockets_find(struct geometry *geometry, const struct molecule *molecule, struct triangle_mesh *mesh,
                       bool smooth, double wide, double least, struct mesh_pockets *pockets, struct failure *failure);
