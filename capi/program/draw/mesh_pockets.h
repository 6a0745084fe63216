/* Pockets for a picture of the surface. */
#pragma once

#include <stdbool.h>

#include "draw/mesh_picture.h"
#include "read/failure.h"
#include "read/geometry.h"
#include "write/mesh_file.h"

/* Find the pockets in which the probe of the mesh fits, but which one of radius `wide` does not reach from outside: the
 * widest first, and only those that are wider than their mouths by `least`, with their numbers among all, from 1 on. A
 * point of the surface belongs to a pocket if a probe that touches it there rises to a maximum of the pocket; triangles
 * are split where this changes. Free of_triangle and of_patch on true and on false. */
bool mesh_pockets_find(struct geometry *geometry, const struct molecule *molecule, struct triangle_mesh *mesh,
                       bool smooth, double wide, double least, struct mesh_pockets *pockets, struct failure *failure);
